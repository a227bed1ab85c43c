// SPDX-License-Identifier: Apache-2.0
// Polynomials in the square of an angle: what they interpolate, how far off they are, and what rotations make of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <polhode/chebyshev.hpp>
#include <polhode/lie/rotation_series.hpp>
#include <polhode/simd.hpp>

namespace polhode {
namespace {

/// cos t, sin t / t, (1 - cos t)/t^2, (1 - sin t / t)/t^2 of q = t^2, by the series of the last two where they cancel.
long double closed_form(long double q, int first) {
  const long double t = std::sqrt(q);
  if (first == 0) return std::cos(t);
  if (t == 0) return first == 1 ? 1 : first == 2 ? 0.5L : 1 / 6.0L;
  if (first == 1) return std::sin(t) / t;
  if (first == 2) return 2 * std::pow(std::sin(t / 2) / t, 2.0L);
  return t > 0.1L ? (1 - std::sin(t) / t) / q
                  : 1 / 6.0L - q / 120 + q * q / 5040 - q * q * q / 362880 + q * q * q * q / 39916800;
}

TEST(Chebyshev, SeriesAreTheirFunctions) {
  for (int first = 0; first <= 3; ++first)
    for (const long double q : {0.0L, 1e-6L, 0.01L, 0.3L, 1.0L, 2.5L})
      EXPECT_NEAR(static_cast<double>(detail::cosine_series(q, first) / closed_form(q, first)), 1, 2.3e-16)
          << first << ' ' << static_cast<double>(q);
}

template <int degree>
void expect_error_within_its_bound(int first, double bound) {
  const auto p = cosine_polynomial<degree>(first, bound);
  long double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const long double q = static_cast<long double>(bound) * i / 1000;
    long double sum = 0;
    for (std::size_t k = p.size(); k-- > 0;) sum = sum * q + p[k];
    worst = std::max(worst, std::fabs(sum - closed_form(q, first)));
  }
  const double stated = 2 * std::pow(bound / 4, degree + 1) / std::tgamma(2 * degree + 3 + first);
  EXPECT_LE(static_cast<double>(worst), 1.1 * stated + 1e-16) << degree << ' ' << first;
  EXPECT_GE(static_cast<double>(worst), 0.5 * stated - 1e-16) << degree << ' ' << first;  // near-best, and no better
}

TEST(Chebyshev, PolynomialsAreOffByWhatTheyState) {
  for (int first = 0; first <= 3; ++first) {
    expect_error_within_its_bound<1>(first, 1);
    expect_error_within_its_bound<2>(first, 1);
    expect_error_within_its_bound<3>(first, 2);
    expect_error_within_its_bound<6>(first, 0.5);
  }
}

// Of degree 1 the interpolation is at bound cos^2(pi/8) and bound cos^2(3 pi/8), and a polynomial is itself.
TEST(Chebyshev, InterpolatesAtItsPoints) {
  const auto square = chebyshev_interpolation<1>([](long double q) { return q * q; }, 3.0L);
  const double high = 3 * std::pow(std::cos(std::numbers::pi / 8), 2),
               low = 3 * std::pow(std::cos(3 * std::numbers::pi / 8), 2);
  for (const double q : {high, low}) EXPECT_NEAR(evaluate(square, q), q * q, 1e-14);
  const auto itself = chebyshev_interpolation<3>([](long double q) { return 2 - q + 5 * q * q * q; }, 2.0L);
  const double expected[] = {2, -1, 0, 5};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(itself[k], expected[k], 1e-16 * 50);
}

TEST(Chebyshev, HornersRule) {
  const std::array p{1.0, -2.0, 0.5, 3.0};
  EXPECT_EQ(evaluate(p, 2.0), 1 - 4 + 2 + 24);
  EXPECT_EQ(evaluate(std::array{4.0}, 7.0), 4);
}

// Within reach, at its edge, and far beyond it, lane by lane.
TEST(RotationSeries, IsTheClosedFormEverywhere) {
  using series = rotation_series<8, 1.0, 3>;
  pack mixed;
  const double squares[] = {0, 1e-12, 0.2, 1.0, 1.0000001, 4.0, 39.0, 1e4};
  for (const double q : squares) {
    const auto found = series::of(q);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto expected = static_cast<double>(closed_form(q, static_cast<int>(k) + 1));
      EXPECT_NEAR(found[k], expected, 4e-16) << q << ' ' << k;
    }
  }
  for (std::size_t lane = 0; lane < pack::size(); ++lane) mixed[lane] = squares[lane % 8];
  const auto found = series::of(mixed);
  for (std::size_t lane = 0; lane < pack::size(); ++lane)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[k][lane], series::of(squares[lane % 8])[k]) << lane;
}

// Of degree 2 the polynomial would be off by 1e-5 at these squares, which lie beyond its reach but below 1.
TEST(RotationSeries, LeavesItsPolynomialsAtTheReachThatItIsGiven) {
  for (const double q : {0.3, 0.7, 0.99}) {
    const auto found = rotation_series<2, 0.5, 3>::of(q);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(found[k], static_cast<double>(closed_form(q, static_cast<int>(k) + 1)), 2.3e-16 / q) << q << ' ' << k;
  }
}

}  // namespace
}  // namespace polhode
