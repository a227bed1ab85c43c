// How a block of normals is filled, from either generator: the body of the entries in isa/.
#pragma once

#include <algorithm>
#include <array>

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

/// Rows, one a channel and step, from words to scaled doubles: some rows of words first, then their quantiles, since a
/// load soon after a store of 512 bits waits for it.
template <noise_generator G>
class fast_rows {
  using B = bits_of<pack>;
  using F = stdx::native_simd<float>;
  using U = stdx::rebind_simd_t<std::uint32_t, F>;
  static constexpr int counters = static_cast<int>(B::size()), width = static_cast<int>(F::size());
  static constexpr int in_flight = std::min(4, block_lanes / width), batch = 4;

 public:
  explicit fast_rows(const normal_block& request) : request_(request) {}

  void fill() {
    const int all = request_.steps * request_.wanted;
    for (int first = 0; first < all; first += batch) {
      const int end = std::min(first + batch, all);
      for (int row = first; row < end; ++row) draw(row, words_[static_cast<std::size_t>(row - first)].data());
      for (int row = first; row < end; ++row)
        finish(row, words_[static_cast<std::size_t>(row - first)].data() + skipped());
    }
  }

 private:
  /// Paths of the first counter that lie before the block.
  int skipped() const { return static_cast<int>(request_.first_path % 4); }
  int step(int row) const { return row / request_.wanted; }
  std::uint32_t channel(int row) const { return static_cast<std::uint32_t>(row % request_.wanted); }
  noise_address address(int row, int lane) const {
    return {request_.seed, request_.kind, request_.first_path + static_cast<std::uint64_t>(lane),
            request_.first_step + static_cast<std::uint64_t>(step(row))};
  }

  /// The words of all lanes and more, from the first path that shares the first counter.
  void draw(int row, std::uint32_t* words) const {
    // Even lanes count through the first half of the counters, odd lanes through the second.
    const B order([](std::size_t i) { return i / 2 + i % 2 * (counters / 2); });
    const noise_address first = address(row, 0);
    for (int i = 0; i < skipped() + block_lanes; i += 4 * counters) {
      const B group = B(first.path / 4 + static_cast<std::uint64_t>(i) / 4) + order;
      const auto blocks = random_blocks<G>(counter(first, group, channel(row), block_use::fast), first.seed);
      std::bit_cast<U>(blocks[0]).copy_to(words + i, stdx::element_aligned);
      std::bit_cast<U>(blocks[1]).copy_to(words + i + 2 * counters, stdx::element_aligned);
    }
  }

  void finish(int row, const std::uint32_t* words) const {
    double* out = request_.out + (step(row) * request_.rows + static_cast<int>(channel(row))) * block_lanes;
    U smallest(0x7FFFFFFFu);
    for (int lane = 0; lane < block_lanes; lane += width * in_flight) {
      std::array<U, in_flight> word;
      unrolled<in_flight>([&](std::size_t i) {
        word[i].copy_from(words + lane + i * U::size(), stdx::element_aligned);
        smallest = stdx::min(smallest, U(word[i] & U(0x7FFFFFFFu)));
      });
      const auto x = quantiles<F>(word);
      unrolled<in_flight>([&](std::size_t i) { store_scaled(x[i], request_.scale, out + lane + i * U::size()); });
    }
    if (stdx::any_of(in_tail(smallest))) [[unlikely]]
      replace_tails(row, words, out);
  }

  [[gnu::noinline]] void replace_tails(int row, const std::uint32_t* words, double* out) const {
    for (int lane = 0; lane < block_lanes; ++lane)
      if (in_tail(words[lane]))
        out[lane] = request_.scale * double{tail_normal<G>(address(row, lane), channel(row), words[lane])};
  }

  const normal_block& request_;
  alignas(64) std::array<std::array<std::uint32_t, (block_lanes / 16 + 2 * counters) * 16>, batch> words_;
};

template <noise_generator G>
void fill(const normal_block& request) {
  request.source.quality == noise_quality::fast ? fast_rows<G>(request).fill() : fill_precise<G>(request);
}

}  // namespace polhode
