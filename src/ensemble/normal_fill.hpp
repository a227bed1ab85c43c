// How a block of normals is filled, from either generator: the body of the entries in isa/.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include <polhode/noise/normal.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/normal_block.hpp"

namespace polhode {

template <noise_generator G>
void fill_precise(const normal_block& request) {
  using B = bits_of<pack>;
  constexpr int width = static_cast<int>(pack::size());
  for (int step = 0; step < request.steps; ++step) {
    const noise_address address{request.seed, request.kind, 0, request.first_step + static_cast<std::uint64_t>(step)};
    double* row = request.out + step * request.rows * block_lanes;
    for (int k = 0; k < request.wanted; k += 2, row += 2 * block_lanes)
      for (int lane = 0; lane < block_lanes; lane += width) {
        const B path([&](auto i) { return request.first_path + static_cast<std::uint64_t>(lane) + i; });
        const auto pair = normal_pair<pack, G>(address, path, static_cast<std::uint32_t>(k / 2));
        (pack(request.scale) * pair[0]).copy_to(row + lane, stdx::element_aligned);
        if (k + 1 < request.wanted)
          (pack(request.scale) * pair[1]).copy_to(row + block_lanes + lane, stdx::element_aligned);
      }
  }
}

/// Fast normals of `Lanes` paths from `first_path`, a multiple of 4, a row (one step, one channel) after another. Between
/// counters and doubles all is in registers.
template <noise_generator G, int Lanes>
class fast_rows {
  using B = bits_of<pack>;
  using F = stdx::native_simd<float>;
  using U = stdx::rebind_simd_t<std::uint32_t, F>;
  static constexpr std::size_t width = U::size(), words = Lanes / width, counters = words / 2;
  static constexpr std::size_t in_flight = std::gcd(std::size_t{4}, words);
  static_assert(Lanes % (2 * width) == 0);

 public:
  fast_rows(const normal_block& request, std::uint64_t first_path)
      : request_(request), first_path_(first_path), blocks_(request.seed) {
    // Even lanes count through the first half of a pack's counters, odd lanes through the second.
    const B order([](std::size_t i) { return i / 2 + i % 2 * (B::size() / 2); });
    unrolled<counters>([&](std::size_t i) { group_[i] = B(first_path / 4 + i * B::size()) + order; });
  }

  void fill(int step, std::uint32_t channel, double* out) const {
    const auto block = draw(step, channel);
    U smallest(0x7FFFFFFFu);
    unrolled<words / in_flight>([&](std::size_t part) {
      std::array<U, in_flight> word;
      unrolled<in_flight>([&](std::size_t i) {
        word[i] = std::bit_cast<U>(block[part * in_flight + i]);
        smallest = stdx::min(smallest, U(word[i] & U(0x7FFFFFFFu)));
      });
      const auto x = quantiles<F>(word);
      unrolled<in_flight>(
          [&](std::size_t i) { store_scaled(x[i], request_.scale, out + (part * in_flight + i) * width); });
    });
    if (stdx::any_of(in_tail(smallest))) [[unlikely]]
      replace_tails(step, channel, out);
  }

 private:
  noise_address address(int step, int lane) const {
    return {request_.seed, request_.kind, first_path_ + static_cast<std::uint64_t>(lane),
            request_.first_step + static_cast<std::uint64_t>(step)};
  }

  std::array<B, words> draw(int step, std::uint32_t channel) const {
    const noise_address a = address(step, 0);
    std::array<std::array<B, 2>, counters> halves;
    unrolled<counters>([&](std::size_t i) { halves[i] = counter(a, group_[i], channel, block_use::fast); });
    return blocks_(halves);
  }

  /// Draws once more, so that the words need not be kept.
  [[gnu::noinline]] void replace_tails(int step, std::uint32_t channel, double* out) const {
    const auto word = std::bit_cast<std::array<std::uint32_t, Lanes>>(draw(step, channel));
    for (int lane = 0; lane < Lanes; ++lane)
      if (const std::uint32_t bits = word[static_cast<std::size_t>(lane)]; in_tail(bits))
        out[lane] = request_.scale * double{tail_normal<G>(address(step, lane), channel, bits)};
  }

  const normal_block& request_;
  std::uint64_t first_path_;
  block_source<G, B> blocks_;
  std::array<B, counters> group_;
};

/// Calls f(step, channel, row) for every wanted row.
template <class F>
void for_each_row(const normal_block& request, const F& f) {
  for (int step = 0; step < request.steps; ++step)
    for (int k = 0; k < request.wanted; ++k)
      f(step, static_cast<std::uint32_t>(k), request.out + (step * request.rows + k) * block_lanes);
}

template <noise_generator G>
void fill_fast(const normal_block& request) {
  // Four paths share a counter: a block that starts between two is cut out of a wider one.
  const auto skipped = request.first_path % 4;
  if (skipped == 0) {
    const fast_rows<G, block_lanes> rows(request, request.first_path);
    for_each_row(request, [&](int step, std::uint32_t channel, double* row) { rows.fill(step, channel, row); });
  } else {
    constexpr int wider = block_lanes + 2 * static_cast<int>(stdx::native_simd<float>::size());
    const fast_rows<G, wider> rows(request, request.first_path - skipped);
    std::array<double, wider> whole;
    for_each_row(request, [&](int step, std::uint32_t channel, double* row) {
      rows.fill(step, channel, whole.data());
      std::copy_n(whole.data() + skipped, block_lanes, row);
    });
  }
}

template <noise_generator G>
void fill(const normal_block& request) {
  request.source.quality == noise_quality::fast ? fill_fast<G>(request) : fill_precise<G>(request);
}

}  // namespace polhode
