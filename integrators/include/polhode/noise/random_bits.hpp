// SPDX-License-Identifier: Apache-2.0
// 128 random bits at a counter, from either generator: one interface for one counter and for packs of them.
#pragma once

#include <polhode/noise/address.hpp>
#include <polhode/noise/ars.hpp>
#include <polhode/noise/philox.hpp>

namespace polhode {

/// Whole 128-bit blocks for packs of counters. The round keys are kept.
template <noise_generator G, class B>
requires is_pack<B>
class block_source {
 public:
  explicit block_source(std::uint64_t seed) : generator_(make(seed)) {}

  /// Of N packs of counters, given by their halves, 2 N packs of blocks (low half, high half, low half, …): for each
  /// pack first those of its even lanes, then those of its odd.
  template <std::size_t N>
  std::array<B, 2 * N> operator()(const std::array<std::array<B, 2>, N>& counters) const {
    if constexpr (G == noise_generator::ars)
      return generator_(interleaved(counters));
    else
      return interleaved(generator_(counters));
  }

 private:
  static auto make(std::uint64_t seed) {
    if constexpr (G == noise_generator::ars)
      return ars<B>({seed, 0});
    else
      return philox<B>(seed);
  }

  template <std::size_t N>
  static std::array<B, 2 * N> interleaved(const std::array<std::array<B, 2>, N>& halves) {
    std::array<B, 2 * N> out;
    unrolled<N>([&](std::size_t i) {
      const auto blocks = interleave(halves[i][0], halves[i][1]);
      out[2 * i] = blocks[0], out[2 * i + 1] = blocks[1];
    });
    return out;
  }

  decltype(make(0)) generator_;
};

/// The two halves of the block at every counter.
template <noise_generator G, class B>
std::array<B, 2> random_bits(const std::array<B, 2>& counter, std::uint64_t seed) {
  if constexpr (G == noise_generator::philox) {
    return philox<B>(seed)(std::to_array({counter}))[0];
  } else if constexpr (is_pack<B>) {
    const auto blocks = block_source<G, B>(seed)(std::to_array({counter}));
    return interleave(blocks[0], blocks[1]);
  } else {
    return ars4x32(counter, {seed, 0});
  }
}

/// The four words at (address, block) from Philox4x32-10.
inline philox_words<std::uint64_t> random_words(const noise_address& a, std::uint32_t block) {
  const auto bits = random_bits<noise_generator::philox>(counter(a, a.path, block), a.seed);
  return {bits[0] & 0xFFFFFFFF, bits[0] >> 32, bits[1] & 0xFFFFFFFF, bits[1] >> 32};
}

}  // namespace polhode
