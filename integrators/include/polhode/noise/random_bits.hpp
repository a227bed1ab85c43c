// SPDX-License-Identifier: Apache-2.0
// 128 random bits at a counter, from either generator: one interface for one counter and for packs of them.
#pragma once

#include <polhode/noise/address.hpp>
#include <polhode/noise/ars.hpp>
#include <polhode/noise/philox.hpp>

namespace polhode {

/// Of packs of counters (noise/block_source.hpp, which whoever draws for packs includes).
template <noise_generator G, class B>
requires is_pack<B>
class block_source;

/// The two halves of the block at every counter.
template <noise_generator G, class B>
std::array<B, 2> random_bits(const std::array<B, 2>& counter, std::uint64_t seed) {
  if constexpr (G == noise_generator::philox) {
    return philox<B>(seed)(std::to_array({counter}))[0];
  } else if constexpr (is_pack<B>) {
    return block_source<G, B>(seed).halves(counter);
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
