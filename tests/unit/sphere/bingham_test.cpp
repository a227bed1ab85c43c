// SPDX-License-Identifier: Apache-2.0
// Moments of the Bingham law, against sums over a fine grid of the sphere and against their own derivatives.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "sphere/closed_forms/gibbs_moments.hpp"

namespace polhode {
namespace {

/// In panels of the height z, between the poles and the equator ever shorter towards the poles, and at equal angles.
bingham_moments on_a_grid(double a, double b, double beta) {
  using rule = boost::math::quadrature::gauss<double, 30>;
  const auto over_angles = [=](double z, const auto& f) {
    constexpr int angles = 512;
    double sum = 0;
    for (int i = 0; i < angles; ++i) {
      const double c = std::cos(2 * std::numbers::pi * i / angles), x1 = (1 - z) * (1 + z) * c * c,
                   x2 = (1 - z) * (1 + z) - x1, y = a * x1 + b * x2;
      sum += std::exp(-beta * y) * f(x1, x2, y);
    }
    return sum / angles;
  };
  const auto mean_of = [&](const auto& f) {
    double total = 0;
    for (double low = 0; low < 1; low = low < 0.99 ? (1 + low) / 2 : 1)
      total += rule::integrate([&](double z) { return over_angles(z, f); }, low, low < 0.99 ? (1 + low) / 2 : 1);
    return total;
  };
  const double all = mean_of([](double, double, double) { return 1.0; });
  bingham_moments out;
  out.square[0] = mean_of([](double x1, double, double) { return x1; }) / all;
  out.square[1] = mean_of([](double, double x2, double) { return x2; }) / all;
  out.square[2] = mean_of([](double x1, double x2, double) { return 1 - x1 - x2; }) / all;
  out.mean = mean_of([](double, double, double y) { return y; }) / all;
  out.variance = mean_of([&](double, double, double y) { return (y - out.mean) * (y - out.mean); }) / all;
  return out;
}

void expect_near(const bingham_moments& found, const bingham_moments& expected, double tolerance,
                 const std::string& where) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(found.square[k], expected.square[k], tolerance * expected.square[k]) << where << ", square " << k;
  EXPECT_NEAR(found.mean, expected.mean, tolerance * expected.mean) << where << ", mean";
  EXPECT_NEAR(found.variance, expected.variance, tolerance * expected.variance) << where << ", variance";
}

// The gap a - b from none to forty times the rest: the ratio of Bessel functions by its series and in closed form.
TEST(Bingham, IsTheSumOverTheSphere) {
  for (const double beta : {0.0, 1e-5, 1.9e-4, 0.1, 1.0, 7.0, 90.0})
    for (const double b : {0.0, 0.02, 0.5, 1.0}) {
      const auto found = bingham(1, b, beta);
      expect_near(found, on_a_grid(1, b, beta), 1e-12, fmt::format("b = {}, beta = {}", b, beta));
      EXPECT_GT(found.relative_uncertainty, 0);
      EXPECT_LT(found.relative_uncertainty, 1e-12);
    }
}

// Rounding of 32 last digits, and of two integrals at least the 2 that Boost says of each.
TEST(Bingham, IsNeverMoreCertainThanRounding) {
  for (const double beta : {0.0, 1.0, 30.0, 1e6})
    for (const double b : {0.0, 0.5, 0.999})
      EXPECT_GE(bingham(1, b, beta).relative_uncertainty, 35.9 * std::numeric_limits<double>::epsilon()) << beta << b;
}

TEST(Bingham, WithoutATemperatureIsUniform) {
  const auto found = bingham(3, 2, 0);
  for (const double square : found.square) EXPECT_NEAR(square, 1.0 / 3, 1e-14);
  EXPECT_NEAR(found.mean, 5.0 / 3, 1e-14);
  EXPECT_NEAR(found.variance, (9 + 4 - 3 * 2) * 4 / 45.0, 1e-14);  // E x^4 = 1/5, E x^2 y^2 = 1/15
}

// Between the two wells at the poles: of the plane, x_1 and x_2 of variance 1 / (2 beta a) and 1 / (2 beta b).
TEST(Bingham, InDeepWellsIsNormal) {
  for (const double beta : {1e6, 1e10, 1e15}) {
    const auto found = bingham(3, 2, beta);
    EXPECT_NEAR(6 * beta * found.square[0], 1, 3 / beta);
    EXPECT_NEAR(4 * beta * found.square[1], 1, 3 / beta);
    EXPECT_NEAR(found.square[2], 1, 1 / beta);
    EXPECT_NEAR(beta * found.mean, 1, 3 / beta);
    EXPECT_NEAR(beta * beta * found.variance, 1, 6 / beta + 1e-12);
  }
}

// The derivative of log Z: Var y = -d E y / d beta. And the squares are of one vector of length 1.
TEST(Bingham, VarianceIsTheSlopeOfTheMean) {
  for (const double b : {0.0, 0.3, 0.999, 1.0})
    for (const double beta : {1e-3, 0.5, 20.0, 45.0, 300.0, 3000.0, 1e5}) {
      const double step = 1e-3 * beta;
      const auto at = [&](int i) { return bingham(1, b, beta + i * step).mean; };
      const double slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step);
      const auto found = bingham(1, b, beta);
      const auto where = fmt::format("b = {}, beta = {}", b, beta);
      EXPECT_NEAR(found.variance, -slope, 1e-9 * found.variance + 1e-14 * found.mean / step) << where;
      EXPECT_NEAR(found.square[0] + found.square[1] + found.square[2], 1, 1e-14) << where;
      EXPECT_NEAR(found.square[0] + b * found.square[1], found.mean, 1e-14 * found.mean) << where;
    }
}

}  // namespace
}  // namespace polhode
