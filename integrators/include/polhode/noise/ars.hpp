// ARS4x32-7: 128 random bits as a pure function of a 128-bit counter and a 128-bit key, by seven rounds of AES whose
// round keys form a Weyl sequence. Fast where the processor has AES instructions, the same bits everywhere.
//
// Source: Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3, SC'11, section 3.2. Held by the
// known answers published with it.
#pragma once

#include <array>
#include <cstdint>

#include <polhode/simd.hpp>

namespace polhode {

/// The key of round i: key + i (floor(2^64 golden ratio), floor(2^64 (sqrt(3) - 1))), each half modulo 2^64.
constexpr aes_block ars_round_key(const aes_block& key, std::size_t i) {
  return {key[0] + i * 0x9E3779B97F4A7C15, key[1] + i * 0xBB67AE8584CAA73B};
}

/// Words 0, 1 of the source are the low half of a block.
template <std::size_t Rounds = 7>
aes_block ars4x32(const aes_block& counter, const aes_block& key) {
  std::array<aes_block, Rounds + 1> keys;
  for (std::size_t i = 0; i <= Rounds; ++i) keys[i] = ars_round_key(key, i);
  return twin::aes(counter, keys);
}

/// For a pack of blocks: low halves in the even lanes, high halves in the odd.
template <std::size_t Rounds = 7, class B>
requires is_pack<B> B ars4x32(const B& counter, const aes_block& key) {
  std::array<B, Rounds + 1> keys;
  for (std::size_t i = 0; i <= Rounds; ++i) {
    const aes_block k = ars_round_key(key, i);
    keys[i] = B([&](std::size_t lane) { return k[lane % 2]; });
  }
  return aes(counter, keys);
}

}  // namespace polhode
