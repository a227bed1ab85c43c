// Philox4x32-10: 128 random bits as a pure function of a 128-bit counter and a 64-bit key, for one counter or a pack of
// them.
//
// Source: Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3, SC'11, section 3.3. Held by the
// known answers published with it.
#pragma once

#include <array>
#include <cstdint>

#include <polhode/simd.hpp>

namespace polhode {

/// Four words of 32 bits, each in a 64-bit lane (std::uint64_t or a pack of them) with its upper half zero.
template <class B>
using philox_words = std::array<B, 4>;

template <class B>
philox_words<B> philox4x32_10(philox_words<B> x, std::uint64_t seed) {
  const B word(0xFFFFFFFF);
  auto key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const B p = multiply_low_words(B(std::uint64_t{0xD2511F53}), x[0]);
    const B q = multiply_low_words(B(std::uint64_t{0xCD9E8D57}), x[2]);
    x = {(q >> 32) ^ x[1] ^ B(std::uint64_t{key0}), q & word, (p >> 32) ^ x[3] ^ B(std::uint64_t{key1}), p & word};
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  return x;
}

}  // namespace polhode
