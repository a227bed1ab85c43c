// 128 random bits at a counter, from either generator: one interface for one counter and for packs of them.
#pragma once

#include <polhode/noise/address.hpp>
#include <polhode/noise/ars.hpp>
#include <polhode/noise/philox.hpp>

namespace polhode {

/// Two packs of whole 128-bit blocks (low half, high half, low half, …) at the counters whose halves are given: first
/// those of the even lanes, then those of the odd.
template <noise_generator G, class B>
requires is_pack<B> std::array<B, 2> random_blocks(const std::array<B, 2>& counter, std::uint64_t seed) {
  if constexpr (G == noise_generator::ars) {
    const auto blocks = interleave(counter[0], counter[1]);
    return {ars4x32(blocks[0], {seed, 0}), ars4x32(blocks[1], {seed, 0})};
  } else {
    const auto halves = philox4x32_10(counter, seed);
    return interleave(halves[0], halves[1]);
  }
}

/// The two halves of the block at every counter.
template <noise_generator G, class B>
std::array<B, 2> random_bits(const std::array<B, 2>& counter, std::uint64_t seed) {
  if constexpr (G == noise_generator::philox) {
    return philox4x32_10(counter, seed);
  } else if constexpr (is_pack<B>) {
    const auto blocks = random_blocks<G>(counter, seed);
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
