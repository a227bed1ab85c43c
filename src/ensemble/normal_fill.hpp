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

/// One channel of a block at one step, from words to scaled doubles.
template <noise_generator G>
class fast_row {
  using B = bits_of<pack>;
  using F = stdx::native_simd<float>;
  using U = stdx::rebind_simd_t<std::uint32_t, F>;
  static constexpr int counters = static_cast<int>(B::size()), width = static_cast<int>(F::size());
  static constexpr int in_flight = std::min(4, block_lanes / width);

 public:
  void fill(const noise_address& first, std::uint32_t channel, double scale, double* out) {
    const auto skipped = static_cast<int>(first.path % 4);  // paths of the first counter that lie before the block
    draw(first, channel, skipped + block_lanes);
    const std::uint32_t* words = words_.data() + skipped;
    U smallest(0x7FFFFFFFu);
    for (int lane = 0; lane < block_lanes; lane += width * in_flight) {
      std::array<U, in_flight> word;
      unrolled<in_flight>([&](std::size_t i) {
        word[i].copy_from(words + lane + i * U::size(), stdx::element_aligned);
        smallest = stdx::min(smallest, U(word[i] & U(0x7FFFFFFFu)));
      });
      const auto x = quantiles<F>(word);
      unrolled<in_flight>([&](std::size_t i) { store_scaled(x[i], scale, out + lane + i * U::size()); });
    }
    if (stdx::any_of(in_tail(smallest))) [[unlikely]]
      replace_tails(first, channel, words, scale, out);
  }

 private:
  /// The words of `wanted` paths and more, from the first path that shares the first counter.
  void draw(const noise_address& first, std::uint32_t channel, int wanted) {
    // Even lanes count through the first half of the counters, odd lanes through the second.
    const B order([](std::size_t i) { return i / 2 + i % 2 * (counters / 2); });
    for (int i = 0; i < wanted; i += 4 * counters) {
      const B group = B(first.path / 4 + static_cast<std::uint64_t>(i) / 4) + order;
      const auto blocks = random_blocks<G>(counter(first, group, channel, block_use::fast), first.seed);
      for (int half = 0; half < 2; ++half)
        std::bit_cast<U>(blocks[static_cast<std::size_t>(half)])
            .copy_to(words_.data() + i + half * 2 * counters, stdx::element_aligned);
    }
  }

  [[gnu::noinline]] static void replace_tails(const noise_address& first, std::uint32_t channel,
                                              const std::uint32_t* words, double scale, double* out) {
    for (int lane = 0; lane < block_lanes; ++lane)
      if (in_tail(words[lane])) {
        noise_address a = first;
        a.path += static_cast<std::uint64_t>(lane);
        out[lane] = scale * double{tail_normal<G>(a, channel, words[lane])};
      }
  }

  alignas(64) std::array<std::uint32_t, block_lanes + 4 + 4 * counters> words_;
};

template <noise_generator G>
void fill_fast(const normal_block& request) {
  fast_row<G> row;
  for (int step = 0; step < request.steps; ++step) {
    const noise_address first{request.seed, request.kind, request.first_path,
                              request.first_step + static_cast<std::uint64_t>(step)};
    for (int k = 0; k < request.wanted; ++k)
      row.fill(first, static_cast<std::uint32_t>(k), request.scale,
               request.out + (step * request.rows + k) * block_lanes);
  }
}

template <noise_generator G>
void fill(const normal_block& request) {
  request.source.quality == noise_quality::fast ? fill_fast<G>(request) : fill_precise<G>(request);
}

}  // namespace polhode
