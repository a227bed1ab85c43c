// ARS4x32-7: 128 random bits as a pure function of a 128-bit counter and a 128-bit key, by seven rounds of AES whose round
// keys form a Weyl sequence. Fast where the processor has AES instructions, the same bits everywhere.
//
// Source: Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3, SC'11, section 3.2. Held by the known
// answers published with it.
#pragma once

#include <array>
#include <cstdint>

#include <polhode/simd.hpp>

namespace polhode {

using ars_block = std::array<std::uint64_t, 2>;  ///< low and high half; words 0, 1 of the source are the low half

/// The key of round i: key + i (floor(2^64 golden ratio), floor(2^64 (sqrt(3) - 1))), each half modulo 2^64.
constexpr ars_block ars_round_key(const ars_block& key, unsigned i) {
  return {key[0] + i * 0x9E3779B97F4A7C15, key[1] + i * 0xBB67AE8584CAA73B};
}

template <unsigned Rounds = 7>
ars_block ars4x32(const ars_block& counter, const ars_block& key) {
  ars_block x{counter[0] ^ key[0], counter[1] ^ key[1]};
  for (unsigned i = 1; i < Rounds; ++i) x = twin::aes_round<false>(x, ars_round_key(key, i));
  return twin::aes_round<true>(x, ars_round_key(key, Rounds));
}

/// For packs of blocks: low halves in the even lanes, high halves in the odd.
template <unsigned Rounds = 7, class B, std::size_t N>
requires is_pack<B> std::array<B, N> ars4x32(std::array<B, N> x, const ars_block& key) {
  const auto round_key = [&](unsigned i) {
    const ars_block k = ars_round_key(key, i);
    return B([&](std::size_t lane) { return k[lane % 2]; });
  };
  for (B& block : x) block ^= round_key(0);
  for (unsigned i = 1; i < Rounds; ++i)
    for (B& block : x) block = aes_round<false>(block, round_key(i));
  for (B& block : x) block = aes_round<true>(block, round_key(Rounds));
  return x;
}

}  // namespace polhode
