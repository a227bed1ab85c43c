// SPDX-License-Identifier: Apache-2.0
// Philox4x32-10: 128 random bits as a pure function of a 128-bit counter and a 64-bit key, for one counter or for packs
// of them.
//
// Source: Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3, SC'11, section 3.3. Held by the
// known answers published with it.
#pragma once

#include <array>
#include <cstdint>

#include <polhode/words.hpp>

namespace polhode {

/// Four words of 32 bits, each in the low half of a 64-bit lane (std::uint64_t or a pack of them).
template <class B>
using philox_words = std::array<B, 4>;

/// The round keys are kept.
template <class B>
class philox {
 public:
  explicit philox(std::uint64_t seed) {
    auto key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
    for (auto& key : keys_) {
      key = {B(std::uint64_t{key0}), B(std::uint64_t{key1})};
      key0 += 0x9E3779B9;
      key1 += 0xBB67AE85;
    }
  }

  /// Only the low halves of what comes in and goes out count. Several counters advance round by round, since each is
  /// one long chain of operations that wait for each other.
  template <std::size_t N>
  std::array<philox_words<B>, N> words(const std::array<philox_words<B>, N>& counters) const {
    auto x = counters;
    unrolled<10>([&](std::size_t round) {
      const auto& key = keys_[round];
      std::array<B, N> p, q;
      unrolled<N>([&](std::size_t i) {
        p[i] = multiply_low_words(B(std::uint64_t{0xD2511F53}), x[i][0]);
        q[i] = multiply_low_words(B(std::uint64_t{0xCD9E8D57}), x[i][2]);
      });
      unrolled<N>([&](std::size_t i) {
        x[i] = {(q[i] >> 32) ^ x[i][1] ^ key[0], q[i], (p[i] >> 32) ^ x[i][3] ^ key[1], p[i]};
      });
    });
    return x;
  }

  /// From and to two halves of 64 bits: words 0, 1 and words 2, 3.
  template <std::size_t N>
  std::array<std::array<B, 2>, N> operator()(const std::array<std::array<B, 2>, N>& counters) const {
    std::array<philox_words<B>, N> in;
    unrolled<N>([&](std::size_t i) {
      const auto& [low, high] = counters[i];
      in[i] = {low, low >> 32, high, high >> 32};
    });
    const auto x = words(in);
    std::array<std::array<B, 2>, N> out;
    unrolled<N>([&](std::size_t i) { out[i] = {join_low_words(x[i][0], x[i][1]), join_low_words(x[i][2], x[i][3])}; });
    return out;
  }

 private:
  std::array<std::array<B, 2>, 10> keys_;
};

}  // namespace polhode
