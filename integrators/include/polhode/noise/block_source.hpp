// SPDX-License-Identifier: Apache-2.0
// 128-bit random blocks for packs of counters, from either generator.
#pragma once

#include <array>
#include <cstdint>

#include <polhode/noise/random_bits.hpp>
#include <polhode/simd.hpp>

namespace polhode {

/// For packs of blocks, low halves in the even lanes, high halves in the odd. The round keys are kept.
template <class B, std::size_t Rounds = 7>
requires is_pack<B>
class ars {
 public:
  explicit ars(const aes_block& key) : key_(key) {
    for (std::size_t i = 0; i <= Rounds; ++i) {
      const aes_block k = ars_round_key(key, i);
      keys_[i] = B([&](std::size_t lane) { return k[lane % 2]; });
    }
  }

  template <std::size_t N>
  std::array<B, N> operator()(const std::array<B, N>& counters) const {
    if constexpr (has_aes<B>) {
      return aes(counters, keys_);
    } else {
      std::array<B, N> out;
      for (std::size_t n = 0; n < N; ++n)
        for (std::size_t i = 0; i < B::size(); i += 2) {
          const aes_block block = ars4x32<Rounds>({counters[n][i], counters[n][i + 1]}, key_);
          out[n][i] = block[0], out[n][i + 1] = block[1];
        }
      return out;
    }
  }

 private:
  aes_block key_;
  std::array<B, Rounds + 1> keys_;
};

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

  /// Of one pack of counters the low halves and the high halves.
  std::array<B, 2> halves(const std::array<B, 2>& counter) const {
    const auto blocks = (*this)(std::to_array({counter}));
    return interleave(blocks[0], blocks[1]);
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

}  // namespace polhode
