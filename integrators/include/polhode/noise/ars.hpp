// SPDX-License-Identifier: Apache-2.0
// ARS4x32-7: 128 random bits as a pure function of a 128-bit counter and a 128-bit key, by seven rounds of AES whose
// round keys form a Weyl sequence. Fast where the processor has AES instructions, the same bits everywhere.
//
// Source: Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3, SC'11, section 3.2. Held by the
// known answers published with it.
#pragma once

#include <array>
#include <cstdint>

#include <polhode/noise/aes_portable.hpp>

namespace polhode {

/// The key of round i: key + i (floor(2^64 golden ratio), floor(2^64 (sqrt(3) - 1))), each half modulo 2^64.
constexpr aes_block ars_round_key(const aes_block& key, std::size_t i) {
  return {key[0] + i * 0x9E3779B97F4A7C15, key[1] + i * 0xBB67AE8584CAA73B};
}

/// Words 0, 1 of the source are the low half of a block.
template <std::size_t Rounds = 7>
constexpr aes_block ars4x32(const aes_block& counter, const aes_block& key) {
  std::array<aes_block, Rounds + 1> keys{};
  for (std::size_t i = 0; i <= Rounds; ++i) keys[i] = ars_round_key(key, i);
  return portable::aes(counter, keys);
}

}  // namespace polhode
