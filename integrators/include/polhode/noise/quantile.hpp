// Fast normals: the quantile of the normal law in single precision, 32 random bits each.
//
// Of a word, bit 31 is the sign and the other 31 bits are m; |x| is the quantile at the two-sided tail probability
//
//   P(|X| > x) = u = (m + 1/2) / 2^31
//
// (with the middle of a float's cell instead of m + 1/2 where 24 bits do not hold m). For m >= 2^15, |x| < 4.33, it is
// one polynomial an octave of m; the absolute error is below 5e-7. Below that, once in 65536 words, further random bits
// replace the 1/2, and the quantile is computed from the definition: the law holds beyond 10 sigma. Compiled without
// contraction of products and sums the bits are the same on every instruction set.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <polhode/noise/box_muller.hpp>

namespace polhode {

/// Coefficients of t^0 ... t^7, t = m / 2^e - 3/2, of the polynomial for 2^e <= m < 2^(e+1) in column (e + 127) mod 16:
/// it interpolates the quantile at the eight Chebyshev nodes t = cos((2 i + 1) pi / 16) / 2.
alignas(64) inline constexpr std::array<std::array<float, 16>, 8> quantile_table{
    {{{0x1.f4badap+1F, 0x1.dee15ap+1F, 0x1.c81a76p+1F, 0x1.b0465p+1F, 0x1.973d58p+1F, 0x1.7ccd7ap+1F, 0x1.60b5d2p+1F,
       0x1.429fdp+1F, 0x1.2213b8p+1F, 0x1.fcc812p+0F, 0x1.ad0a62p+0F, 0x1.516928p+0F, 0x1.c6381p-1F, 0x1.46495ep-2F,
       0x1.0f04e4p+2F, 0x1.04e08cp+2F}},
     {{-0x1.49a6bap-3F, -0x1.5715fap-3F, -0x1.663f64p-3F, -0x1.7788ap-3F, -0x1.8b7ac2p-3F, -0x1.a2d3e6p-3F,
       -0x1.bea45ep-3F, -0x1.e08244p-3F, -0x1.057522p-2F, -0x1.21029cp-2F, -0x1.46b4cap-2F, -0x1.7e5f9ep-2F,
       -0x1.db8e28p-2F, -0x1.518e94p-1F, -0x1.32d3bep-3F, -0x1.3da48ep-3F}},
     {{0x1.9f3018p-5F, 0x1.ae1832p-5F, 0x1.bea4c2p-5F, 0x1.d12526p-5F, 0x1.e5fddp-5F, 0x1.fdaf1ep-5F, 0x1.0c6f0ep-4F,
       0x1.1c2f0ap-4F, 0x1.2e9a9ap-4F, 0x1.444122p-4F, 0x1.5d6a18p-4F, 0x1.786922p-4F, 0x1.87e446p-4F, 0x1.1bb008p-4F,
       0x1.855bb4p-5F, 0x1.91ad08p-5F}},
     {{-0x1.67fb24p-6F, -0x1.74438ap-6F, -0x1.81d464p-6F, -0x1.90e888p-6F, -0x1.a1c9bep-6F, -0x1.b4d59cp-6F,
       -0x1.ca8436p-6F, -0x1.e37106p-6F, -0x1.003372p-5F, -0x1.1137c2p-5F, -0x1.2577d2p-5F, -0x1.3e1c9cp-5F,
       -0x1.600e1ep-5F, -0x1.d6c27cp-5F, -0x1.528e5p-6F, -0x1.5ccbaep-6F}},
     {{0x1.5f3002p-7F, 0x1.6acdbep-7F, 0x1.77984p-7F, 0x1.85c3c6p-7F, 0x1.959164p-7F, 0x1.a75326p-7F, 0x1.bb71b4p-7F,
       0x1.d273fap-7F, 0x1.ed097ap-7F, 0x1.060bacp-6F, 0x1.186334p-6F, 0x1.2e3e6cp-6F, 0x1.477d76p-6F, 0x1.35cb26p-6F,
       0x1.4ad89ap-7F, 0x1.54949ep-7F}},
     {{-0x1.71ef5ep-8F, -0x1.7de4f2p-8F, -0x1.8b08f6p-8F, -0x1.998ecap-8F, -0x1.a9b61ap-8F, -0x1.bbced6p-8F,
       -0x1.d03e7ap-8F, -0x1.e7875cp-8F, -0x1.012942p-7F, -0x1.10be58p-7F, -0x1.23131p-7F, -0x1.38e25p-7F,
       -0x1.535502p-7F, -0x1.91da1cp-7F, -0x1.5ceefep-8F, -0x1.66fe4ep-8F}},
     {{0x1.e84582p-9F, 0x1.f7b2ep-9F, 0x1.044eacp-8F, 0x1.0da21ep-8F, 0x1.17fadap-8F, 0x1.2389bp-8F, 0x1.308c5ap-8F,
       0x1.3f51b6p-8F, 0x1.503fc6p-8F, 0x1.63db6ep-8F, 0x1.7ad27ap-8F, 0x1.960694p-8F, 0x1.b684aap-8F, 0x1.c865d4p-8F,
       0x1.cd1ab2p-9F, 0x1.da213cp-9F}},
     {{-0x1.16d1cep-9F, -0x1.1f81a2p-9F, -0x1.2904f4p-9F, -0x1.337e74p-9F, -0x1.3f18ccp-9F, -0x1.4c0924p-9F,
       -0x1.5a927ap-9F, -0x1.6b0a3ap-9F, -0x1.7dde84p-9F, -0x1.939ea6p-9F, -0x1.ad060cp-9F, -0x1.cb091ap-9F,
       -0x1.eee4e6p-9F, -0x1.14370ep-8F, -0x1.077ef8p-9F, -0x1.0ed8e6p-9F}}}};

template <class U>
auto in_tail(const U& word) {
  return (word & U(0x7FFF8000u)) == U(0u);
}

/// The quantiles of words that are not in the tail: F float and U std::uint32_t, or packs of them. Several at once,
/// stage by stage, since each is one long chain of operations that wait for each other.
template <class F, class U, std::size_t N>
std::array<F, N> quantiles(const std::array<U, N>& words) {
  std::array<U, N> octave;
  std::array<F, N> t, x;
  unrolled<N>([&](std::size_t i) {
    const U m = words[i] & U(0x7FFFFFFFu);
    const U cut = m & ~(m >> 24);  // the first bit that a float drops is cleared: it is cut, not rounded
    const U bits = std::bit_cast<U>(to_float(cut));
    octave[i] = bits >> 23;
    t[i] = std::bit_cast<F>(U((bits & U(0x007FFFFFu)) | U(0x3F800000u))) - F(1.5F);
  });
  unrolled<N>([&](std::size_t i) { x[i] = lookup<F>(quantile_table[7], octave[i]); });
  unrolled<7>([&](std::size_t k) {
    unrolled<N>([&](std::size_t i) { x[i] = x[i] * t[i] + lookup<F>(quantile_table[6 - k], octave[i]); });
  });
  unrolled<N>([&](std::size_t i) { x[i] = std::bit_cast<F>(U(std::bit_cast<U>(x[i]) ^ (words[i] & U(0x80000000u)))); });
  return x;
}
template <class F, class U>
F quantile(const U& word) {
  return quantiles<F>(std::array{word})[0];
}

/// x > 0 with P(|X| > x) = u, for 0 < u < 1e-4. Newton's method on log Q, where Q(x) = phi(x) / (x + 1/(x + 2/(x +
/// 3/...))) (Abramowitz, Stegun, 26.2.14), d log Q/dx = -(x + 1/(x + ...)).
inline double tail_quantile(double u) {
  const double log_half_u = logarithm(u) - std::numbers::ln2;
  double x = square_root(-2 * log_half_u);
  for (int iteration = 0; iteration < 6; ++iteration) {
    double fraction = x;
    for (int k = 60; k > 0; --k) fraction = x + k / fraction;
    const double log_q = -x * x / 2 - logarithm(fraction * square_root(2 * std::numbers::pi));
    x += (log_q - log_half_u) / fraction;
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
