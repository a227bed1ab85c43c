// SPDX-License-Identifier: Apache-2.0
// Dual numbers against derivatives in closed form, in several directions, nested, and in packs.
#include <polhode/dual.hpp>
#include <polhode/simd.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace polhode {
namespace {

using number = dual<double, 2>;

/// x with the directions 1 and -2.
number seed(double x) { return {x, {{1.0, -2.0}}}; }

void expect_dual(const number& found, double value, double slope) {
  EXPECT_NEAR(found.value, value, 4e-16 * std::fabs(value));
  EXPECT_NEAR(found.slope[0], slope, 1e-15 * std::max(1.0, std::fabs(slope)));
  EXPECT_NEAR(found.slope[1], -2 * slope, 2e-15 * std::max(1.0, std::fabs(slope)));
}

TEST(Dual, DerivativesInClosedForm) {
  for (const double x : {-3.0, -0.7, 5e-4, 0.2, 1.0, 5.0}) {
    const auto a = seed(x);
    expect_dual(a * a * a, x * x * x, 3 * x * x);
    expect_dual(number(1.0) / a, 1 / x, -1 / (x * x));
    expect_dual(a / (number(1.0) + a * a), x / (1 + x * x), (1 - x * x) / ((1 + x * x) * (1 + x * x)));
    expect_dual(-a - number(2.0) * a, -3 * x, -3);
    expect_dual(exponential(a), std::exp(x), std::exp(x));
    expect_dual(magnitude(a), std::fabs(x), x < 0 ? -1 : 1);
    expect_dual(square_root(a * a + number(1.0)), std::sqrt(x * x + 1), x / std::sqrt(x * x + 1));
    const auto [sin, cos] = sincos(a);
    expect_dual(sin, std::sin(x), std::cos(x));
    expect_dual(cos, std::cos(x), -std::sin(x));
  }
}

TEST(Dual, TheLengthOfAVectorThatStaysZeroHasNoSlope) {
  expect_dual(square_root(number(0.0)), 0, 0);
  expect_dual(square_root(seed(0) * seed(0)), 0, 0);
  expect_dual(square_root(seed(0)), 0, 0);  // infinite: none stands in for it
}

TEST(Dual, ComparesAndSelectsByTheValue) {
  const auto low = seed(1), high = seed(2);
  EXPECT_TRUE(low < high && high > low && low <= low && high >= low && low == number(1.0));
  EXPECT_FALSE(low == high || high < low);
  EXPECT_EQ(select(low < high, low, high).value, 1);
  EXPECT_EQ(select(high < low, seed(7), number(3.0)).slope[0], 0);
  EXPECT_TRUE(any(low, low < high));
}

// d/dx and d2/dx2 of sin(x)/x, by a dual number of dual numbers.
TEST(Dual, NestedGivesSecondDerivatives) {
  using second = dual<dual<double, 1>, 1>;
  const double x = 0.8;
  const second a{{x, {{1.0}}}, {{dual<double, 1>(1.0)}}};
  const auto f = sincos(a).sin / a;
  EXPECT_NEAR(f.value.value, std::sin(x) / x, 1e-15);
  EXPECT_NEAR(f.slope[0].value, (x * std::cos(x) - std::sin(x)) / (x * x), 1e-15);
  EXPECT_NEAR(f.slope[0].slope[0], ((2 - x * x) * std::sin(x) - 2 * x * std::cos(x)) / (x * x * x), 1e-14);
}

TEST(Dual, LanesOfAPackAreScalars) {
  using lanes = dual<pack, 2>;
  const pack x([](auto i) { return 0.1 + 0.3 * static_cast<double>(i); });
  const lanes a{x, {{pack(1.0), pack(-2.0)}}};
  const auto f = exponential(sincos(a).cos) / square_root(a);
  for (std::size_t i = 0; i < pack::size(); ++i) {
    const auto b = seed(x[i]);
    const auto g = exponential(sincos(b).cos) / square_root(b);
    EXPECT_NEAR(f.value[i], g.value, 1e-15 * std::fabs(g.value));
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(f.slope[k][i], g.slope[k], 1e-14 * std::fabs(g.slope[k]));
  }
}

}  // namespace
}  // namespace polhode
