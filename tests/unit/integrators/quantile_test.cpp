// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <boost/math/special_functions/erf.hpp>

#include <polhode/noise/quantile.hpp>
#include <polhode/simd.hpp>

namespace polhode {
namespace {

/// x > 0 with P(|X| > x) = u.
long double exact_quantile(long double u) { return std::sqrt(2.0L) * boost::math::erfc_inv(u); }

/// The tail probability that a word of the octave 2^e <= m < 2^(e+1) stands for, at t = m / 2^e - 3/2.
long double probability(int e, long double t) {
  const long double cell = std::max(1.0L, std::ldexp(1.0L, e - 23));
  return std::ldexp(std::ldexp(1.5L + t, e) + cell / 2, -31);
}

/// Newton's interpolation at the seven Chebyshev nodes, multiplied out.
std::array<float, 7> interpolation(int e) {
  std::array<long double, 7> node{}, d{}, a{};
  for (std::size_t i = 0; i < 7; ++i) {
    node[i] = std::cos(std::numbers::pi_v<long double> * static_cast<long double>(2 * i + 1) / 14) / 2;
    d[i] = exact_quantile(probability(e, node[i]));
  }
  for (std::size_t j = 1; j < 7; ++j)
    for (std::size_t i = 6; i >= j; --i) d[i] = (d[i] - d[i - 1]) / (node[i] - node[i - j]);
  for (std::size_t i = 7; i-- > 0;) {
    for (std::size_t k = 6; k > 0; --k) a[k] = a[k - 1] - node[i] * a[k];
    a[0] = d[i] - node[i] * a[0];
  }
  std::array<float, 7> out{};
  for (std::size_t k = 0; k < 7; ++k) out[k] = static_cast<float>(a[k]);
  return out;
}

TEST(Quantile, TableIsTheInterpolation) {
  for (int e = 15; e < 31; ++e)
    for (std::size_t k = 0; k < 7; ++k)
      EXPECT_EQ(quantile_table[k][static_cast<std::size_t>(e + 127) % 16], interpolation(e)[k])
          << "octave " << e << ", t^" << k;
}

TEST(Quantile, TheUpperOctavesHaveTheirColumnsInATableOfTheirOwn) {
  for (std::size_t e = 23; e < 31; ++e)
    for (std::size_t k = 0; k < 7; ++k)
      EXPECT_EQ(upper_quantile_table[k][(e + 127) % 8], quantile_table[k][(e + 127) % 16])
          << "octave " << e << ", t^" << k;
}

double error_at(std::uint32_t m) {
  const int e = 31 - std::countl_zero(m);
  const std::uint32_t cell = e > 23 ? 1u << (e - 23) : 1u;
  const long double u = std::ldexp(static_cast<long double>(2 * std::uint64_t{m / cell * cell} + cell), -32);
  return static_cast<double>(std::fabs(quantile<float>(m) - exact_quantile(u)));
}

TEST(Quantile, IsGoodToSinglePrecision) {
  for (int e = 15; e < 31; ++e) {
    const std::uint32_t first = 1u << e, last = 2 * first - 1;
    double worst = std::max(error_at(first), error_at(last));
    for (std::uint32_t i = 0; i < 2000; ++i)
      worst = std::max(worst, error_at(first + static_cast<std::uint32_t>(std::uint64_t{i} * first / 2000)));
    EXPECT_LT(worst, 8e-7) << "octave " << e;
  }
}

TEST(Quantile, IsOddAndPacksGiveTheSameBits) {
  using F = stdx::native_simd<float>;
  using U = stdx::rebind_simd_t<std::uint32_t, F>;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const std::uint32_t word = i * 2654435769u;
    EXPECT_EQ(in_tail(word), (word & 0x7FFFFFFF) < 0x8000);
    if (in_tail(word)) continue;
    EXPECT_EQ(quantile<float>(word), -quantile<float>(word ^ 0x80000000));
    EXPECT_EQ(quantile<F>(U(word))[0], quantile<float>(word));
  }
}

TEST(Quantile, TailIsExactBeyondTenSigma) {
  for (double log_u = -9.3; log_u > -60; log_u -= 0.01) {
    const double u = std::exp(log_u), exact = static_cast<double>(exact_quantile(u));
    EXPECT_NEAR(tail_quantile(u), exact, 1e-13 * exact) << u;
  }
}

// A tail word's value lies where its m says, its further bits decide within; and the tail joins the body.
TEST(Quantile, TailWordsKeepTheirPlace) {
  for (std::uint32_t m = 0; m < 0x8000; m += 111)
    for (const std::uint32_t sign : {0u, 0x80000000u}) {
      const noise_address a{5, noise_kind::increment, m, 7};
      const float x = tail_normal<noise_generator::philox>(a, 1, m | sign);
      EXPECT_EQ(std::signbit(x), sign != 0);
      const double u = std::erfc(std::fabs(x) / std::numbers::sqrt2) * 0x1p31;
      EXPECT_GT(u, m - 0.1 - m * 1e-5);
      EXPECT_LT(u, m + 1.1 + m * 1e-5);
    }
  EXPECT_NEAR(quantile<float>(0x8000u), tail_quantile(0x8000p-31), 2e-5);
}

}  // namespace
}  // namespace polhode
