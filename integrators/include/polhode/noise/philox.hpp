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

namespace detail {

/// Only the lower halves of what comes in and goes out count.
template <class B>
philox_words<B> philox_rounds(philox_words<B> x, std::uint64_t seed) {
  auto key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const B p = multiply_low_words(B(std::uint64_t{0xD2511F53}), x[0]);
    const B q = multiply_low_words(B(std::uint64_t{0xCD9E8D57}), x[2]);
    x = {(q >> 32) ^ x[1] ^ B(std::uint64_t{key0}), q, (p >> 32) ^ x[3] ^ B(std::uint64_t{key1}), p};
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  return x;
}

}  // namespace detail

template <class B>
philox_words<B> philox4x32_10(const philox_words<B>& counter, std::uint64_t seed) {
  auto x = detail::philox_rounds(counter, seed);
  for (B& word : x) word = word & B(0xFFFFFFFF);
  return x;
}

/// The same from and to two halves of 64 bits: words 0, 1 and words 2, 3.
template <class B>
std::array<B, 2> philox4x32_10(const std::array<B, 2>& counter, std::uint64_t seed) {
  const B word(0xFFFFFFFF);
  const auto x = detail::philox_rounds<B>({counter[0], counter[0] >> 32, counter[1], counter[1] >> 32}, seed);
  return {(x[0] & word) | x[1] << 32, (x[2] & word) | x[3] << 32};
}

}  // namespace polhode
