// SPDX-License-Identifier: Apache-2.0
// How a block of normals is filled, from either generator: the body of the entries in isa/.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include <polhode/noise/block_source.hpp>
#include <polhode/noise/normal.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/normal_block.hpp"

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

/// Fast normals, row by row: one channel at one step. First the words of some rows, then their quantiles, since the
/// constants of one of the two loops fit into registers, those of both do not; then the tails, if there are any.
template <noise_generator G>
class fast_rows {
  using B = bits_of<pack>;
  using F = stdx::native_simd<float>;
  using U = stdx::rebind_simd_t<std::uint32_t, F>;
  static constexpr std::size_t width = U::size(), packs = 4;  ///< that advance together
  static constexpr std::size_t lanes_at_once = packs * width;
  static_assert(block_lanes % lanes_at_once == 0);
  static constexpr int batch = 12;
  using word_row = std::array<std::uint32_t, block_lanes + lanes_at_once>;

 public:
  explicit fast_rows(const normal_block& request) : request_(request), source_(request.seed) {}

  /// Into out, scaled (Real = double), or into singles, as they are (Real = float).
  template <class Real>
  void fill(Real* out) {
    const int all = request_.steps * request_.wanted;
    for (int first = 0; first < all; first += batch) {
      const int end = std::min(first + batch, all);
      for (int row = first; row < end; ++row) draw(row, words_[static_cast<std::size_t>(row - first)]);
      U smallest(0x7FFFFFFFu);
      for (int row = first; row < end; ++row) finish(words_of(row - first), place_of(row, out), smallest);
      if (stdx::any_of(in_tail(smallest))) [[unlikely]]
        for (int row = first; row < end; ++row) replace_tails(row, words_of(row - first), place_of(row, out));
    }
  }

 private:
  /// Paths of the first counter that lie before the block: four share a counter.
  std::size_t skipped() const { return request_.first_path % 4; }
  int step(int row) const { return row / request_.wanted; }
  std::uint32_t channel(int row) const { return static_cast<std::uint32_t>(row % request_.wanted); }
  const std::uint32_t* words_of(int place) const { return words_[static_cast<std::size_t>(place)].data() + skipped(); }
  template <class Real>
  Real* place_of(int row, Real* out) const {
    return out + (step(row) * request_.rows + static_cast<int>(channel(row))) * block_lanes;
  }
  noise_address address(int row, std::size_t lane) const {
    return {request_.seed, request_.kind, request_.first_path + lane,
            request_.first_step + static_cast<std::uint64_t>(step(row))};
  }

  /// The words of all lanes and more, from the first path that shares the first counter.
  void draw(int row, word_row& words) const {
    // Even lanes count through the first half of a pack's counters, odd lanes through the second.
    const B order([](std::size_t i) { return i / 2 + i % 2 * (B::size() / 2); });
    const noise_address first = address(row, 0);
    for (std::size_t lane = 0; lane < skipped() + block_lanes; lane += lanes_at_once) {
      std::array<std::array<B, 2>, packs / 2> counters;
      unrolled<packs / 2>([&](std::size_t i) {
        const B group = B((first.path + lane) / 4 + i * B::size()) + order;
        counters[i] = counter(first, group, channel(row), block_use::fast);
      });
      const auto blocks = source_(counters);
      unrolled<packs>([&](std::size_t i) {
        std::bit_cast<U>(blocks[i]).copy_to(words.data() + lane + i * width, stdx::element_aligned);
      });
    }
  }

  /// Words that lie in the tail are left for later: `smallest` tells.
  template <class Real>
  void finish(const std::uint32_t* words, Real* out, U& smallest) const {
    for (std::size_t lane = 0; lane < block_lanes; lane += lanes_at_once) {
      std::array<U, packs> word;
      unrolled<packs>([&](std::size_t i) {
        word[i].copy_from(words + lane + i * width, stdx::element_aligned);
        smallest = stdx::min(smallest, U(word[i] & U(0x7FFFFFFFu)));
      });
      const auto x = quantiles<F>(word);
      unrolled<packs>([&](std::size_t i) { store(x[i], out + lane + i * width); });
    }
  }

  template <class Real>
  [[gnu::noinline]] void replace_tails(int row, const std::uint32_t* words, Real* out) const {
    for (std::size_t first = 0; first < block_lanes; first += width) {
      if (stdx::none_of(in_tail(U(words + first, stdx::element_aligned)))) continue;
      for (std::size_t lane = first; lane < first + width; ++lane)
        if (in_tail(words[lane])) store(tail_normal<G>(address(row, lane), channel(row), words[lane]), out + lane);
    }
  }

  void store(float x, double* out) const { *out = request_.scale * double{x}; }
  void store(float x, float* out) const { *out = x; }
  void store(const F& x, double* out) const { store_scaled(x, request_.scale, out); }
  void store(const F& x, float* out) const { x.copy_to(out, stdx::element_aligned); }

  const normal_block request_;
  block_source<G, B> source_;
  alignas(64) std::array<word_row, batch> words_;
};

template <noise_generator G>
void fill(const normal_block& request) {
  if (request.source.quality == noise_quality::precise)
    fill_precise<G>(request);
  else if (request.singles != nullptr)
    fast_rows<G>(request).fill(request.singles);
  else
    fast_rows<G>(request).fill(request.out);
}

}  // namespace polhode
