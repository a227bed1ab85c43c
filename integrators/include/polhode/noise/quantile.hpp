// SPDX-License-Identifier: Apache-2.0
// Fast normals: the quantile of the normal law in single precision, 32 random bits each.
//
// Of a word, bit 31 is the sign and the other 31 bits are m; |x| is the quantile at the two-sided tail probability
//
//   P(|X| > x) = u = (m + 1/2) / 2^31
//
// (with the middle of a float's cell instead of m + 1/2 where 24 bits do not hold m). For m >= 2^15, |x| < 4.33, it is
// one polynomial an octave of m; the absolute error is below 8e-7. Below that, once in 65536 words, further random bits
// replace the 1/2, and the quantile is computed from the definition: the law holds beyond 10 sigma. The
// polynomial is evaluated with fused multiply-adds, so the bits are the same on every instruction set; the tail is
// compiled without contraction of products and sums.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <polhode/noise/box_muller.hpp>

namespace polhode {

/// Coefficients of t^0 ... t^6, t = m / 2^e - 3/2, of the polynomial for 2^e <= m < 2^(e+1) in column (e + 127) mod 16:
/// it interpolates the quantile at the seven Chebyshev nodes t = cos((2 i + 1) pi / 14) / 2.
alignas(64) inline constexpr std::array<std::array<float, 16>, 7> quantile_table{
    {{{0x1.f4badcp+1F, 0x1.dee15ap+1F, 0x1.c81a76p+1F, 0x1.b0465p+1F, 0x1.973d58p+1F, 0x1.7ccd7ap+1F, 0x1.60b5d4p+1F,
       0x1.429fdp+1F, 0x1.2213b8p+1F, 0x1.fcc812p+0F, 0x1.ad0a62p+0F, 0x1.51692ap+0F, 0x1.c63812p-1F, 0x1.464964p-2F,
       0x1.0f04e4p+2F, 0x1.04e08cp+2F}},
     {{-0x1.49a89ap-3F, -0x1.5717e8p-3F, -0x1.664164p-3F, -0x1.778abp-3F, -0x1.8b7ce8p-3F, -0x1.a2d622p-3F,
       -0x1.bea6b4p-3F, -0x1.e084b4p-3F, -0x1.05766ap-2F, -0x1.2103f6p-2F, -0x1.46b63ap-2F, -0x1.7e6128p-2F,
       -0x1.db8fd4p-2F, -0x1.518f82p-1F, -0x1.32d584p-3F, -0x1.3da66p-3F}},
     {{0x1.9f2a5p-5F, 0x1.ae123ap-5F, 0x1.be9e98p-5F, 0x1.d11ec6p-5F, 0x1.e5f734p-5F, 0x1.fda83ep-5F, 0x1.0c6b78p-4F,
       0x1.1c2b48p-4F, 0x1.2e96aap-4F, 0x1.443cfap-4F, 0x1.5d65acp-4F, 0x1.78646ap-4F, 0x1.87df32p-4F, 0x1.1baa9cp-4F,
       0x1.85563cp-5F, 0x1.91a76ap-5F}},
     {{-0x1.66172p-6F, -0x1.725072p-6F, -0x1.7fd0c8p-6F, -0x1.8ed2bap-6F, -0x1.9f9fcap-6F, -0x1.b29532p-6F,
       -0x1.c82a8ep-6F, -0x1.e0fac6p-6F, -0x1.fdcffp-6F, -0x1.0fd966p-5F, -0x1.240366p-5F, -0x1.3c8e22p-5F,
       -0x1.5e608p-5F, -0x1.d4e2d6p-5F, -0x1.50c4e8p-6F, -0x1.5af582p-6F}},
     {{0x1.602878p-7F, 0x1.6bcdd8p-7F, 0x1.78a0bap-7F, 0x1.86d572p-7F, 0x1.96ad3ep-7F, 0x1.a87a54p-7F, 0x1.bca598p-7F,
       0x1.d3b63cp-7F, 0x1.ee5c22p-7F, 0x1.06be72p-6F, 0x1.1921p-6F, 0x1.2f093p-6F, 0x1.4857bp-6F, 0x1.36b43cp-6F,
       0x1.4bc38cp-7F, 0x1.55860cp-7F}},
     {{-0x1.aebad8p-8F, -0x1.bc9558p-8F, -0x1.cbcc6ap-8F, -0x1.dc9af8p-8F, -0x1.ef4a02p-8F, -0x1.021a86p-7F,
       -0x1.0de81ap-7F, -0x1.1b5834p-7F, -0x1.2acb6p-7F, -0x1.3cbf9ap-7F, -0x1.51d97p-7F, -0x1.6aee78p-7F,
       -0x1.894a26p-7F, -0x1.ce1626p-7F, -0x1.96631p-8F, -0x1.a20cbep-8F}},
     {{0x1.dde0f2p-9F, 0x1.ecfc7p-9F, 0x1.fd8d56p-9F, 0x1.07e8dcp-8F, 0x1.120b1cp-8F, 0x1.1d5d4ap-8F, 0x1.2a1be8p-8F,
       0x1.389454p-8F, 0x1.492a9ap-8F, 0x1.5c6114p-8F, 0x1.72e23ep-8F, 0x1.8d8b6cp-8F, 0x1.ad63fap-8F, 0x1.bea5eep-8F,
       0x1.c346cap-9F, 0x1.d007e6p-9F}}}};

template <class U>
auto in_tail(const U& word) {
  return (word & U(0x7FFF8000u)) == U(0u);
}

/// The columns of the octaves of m >= 2^23 alone: column (e + 127) mod 8.
alignas(32) inline constexpr auto upper_quantile_table = [] {
  std::array<std::array<float, 8>, 7> out{};
  for (std::size_t k = 0; k < 7; ++k)
    for (std::size_t column = 6; column < 14; ++column) out[k][column % 8] = quantile_table[k][column];
  return out;
}();

/// The quantiles of words that are not in the tail, with the table's columns of their octaves.
template <class F, class U, std::size_t N, class Table>
std::array<F, N> quantiles(const std::array<U, N>& words, const Table& table) {
  std::array<U, N> octave;
  std::array<F, N> t, x;
  unrolled<N>([&](std::size_t i) {
    const U bits = std::bit_cast<U>(cut_to_float(U(words[i] & U(0x7FFFFFFFu))));
    octave[i] = bits >> 23;
    t[i] = std::bit_cast<F>(U((bits & U(0x007FFFFFu)) | U(0x3F800000u))) - F(1.5F);
  });
  unrolled<N>([&](std::size_t i) { x[i] = lookup<F>(table[6], octave[i]); });
  unrolled<6>([&](std::size_t k) {
    unrolled<N>([&](std::size_t i) { x[i] = fused(x[i], t[i], lookup<F>(table[5 - k], octave[i])); });
  });
  unrolled<N>([&](std::size_t i) { x[i] = std::bit_cast<F>(U(std::bit_cast<U>(x[i]) ^ (words[i] & U(0x80000000u)))); });
  return x;
}

/// The quantiles of words that are not in the tail: F float and U std::uint32_t, or packs of them. Several at once,
/// stage by stage, since each is one long chain of operations that wait for each other. A register of eight floats
/// holds the columns of the upper octaves, which are all that is asked for 255 times of 256.
template <class F, class U, std::size_t N>
std::array<F, N> quantiles(const std::array<U, N>& words) {
  if constexpr (is_pack<F>)
    if constexpr (F::size() == 8) {
      std::array<U, N> unsigned_words;
      unrolled<N>([&](std::size_t i) { unsigned_words[i] = words[i] & U(0x7FFFFFFFu); });
      if (of_packs<U>::reach(unsigned_words, U(0x00800000u))) [[likely]]
        return quantiles<F>(words, upper_quantile_table);
    }
  return quantiles<F>(words, quantile_table);
}
template <class F, class U>
F quantile(const U& word) {
  return quantiles<F>(std::array{word})[0];
}

/// x + 1/(x + 2/(x + ... 40/x)), the reciprocal of Mills' ratio, for x > 3.8 (Abramowitz, Stegun, 26.2.14), as a
/// quotient of two sums of positive terms.
inline double inverse_mills_ratio(double x) {
  double above = x, above_before = 1, below = 1, below_before = 0;
  for (int k = 1; k <= 40; ++k) {
    above_before = std::exchange(above, x * above + k * above_before);
    below_before = std::exchange(below, x * below + k * below_before);
  }
  return above / below;
}

/// x > 0 with P(|X| > x) = u, for 0 < u < 1e-4. Newton's method on log Q, where Q = phi / inverse_mills_ratio and d log
/// Q/dx = -inverse_mills_ratio, from the first terms of its expansion for large x.
inline double tail_quantile(double u) {
  const double log_q = logarithm(u) - std::numbers::ln2, log_2_pi = logarithm(2 * std::numbers::pi);
  double x = square_root(-2 * log_q - log_2_pi - logarithm(-2 * log_q));
  for (int iteration = 0; iteration < 3; ++iteration) {
    const double ratio = inverse_mills_ratio(x);
    x -= (log_q + x * x / 2 + log_2_pi / 2 + logarithm(ratio)) / ratio;
  }
  return x;
}

/// The fast normal of a word in the tail; its further bits have a block of their own.
template <noise_generator G>
float tail_normal(const noise_address& a, std::uint32_t channel, std::uint32_t word) {
  const auto further = random_bits<G>(counter(a, a.path, channel, block_use::fast_tail), a.seed);
  const double u = ((word & 0x7FFF) + uniform_of<double>(further[0])) * 0x1p-31;
  const auto x = static_cast<float>(tail_quantile(u));
  return word >> 31 != 0 ? -x : x;
}

/// The fast normal at (address, channel). Four paths share a block: the one at path / 4, whose word path mod 4 this is.
template <noise_generator G = noise_generator::philox>
float fast_normal(const noise_address& a, std::uint32_t channel) {
  const auto bits = random_bits<G>(counter(a, a.path / 4, channel, block_use::fast), a.seed);
  const auto word = static_cast<std::uint32_t>(bits[a.path / 2 % 2] >> 32 * (a.path % 2));
  return in_tail(word) ? tail_normal<G>(a, channel, word) : quantile<float>(word);
}

}  // namespace polhode
