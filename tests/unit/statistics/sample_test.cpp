// SPDX-License-Identifier: Apache-2.0
// The distance of Kolmogorov and Smirnov, and intervals of what may be biased.
#include "statistics/sample.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "statistics/distributions.hpp"

namespace polhode {
namespace {

TEST(KolmogorovSmirnov, DistanceOfASmallSampleByHand) {
  const std::vector<double> x{0.1, 0.4, 0.9};
  EXPECT_NEAR(ks_distance(x, [](double t) { return t; }).value, 2.0 / 3 - 0.4, 1e-15);
}

/// P(|N(bias, 1)| <= half).
double covered(double half, double bias) { return 1 - normal_tail(half - bias) - normal_tail(half + bias); }

TEST(HalfWidthWithBias, CoversNinetyFiveInAHundredAtTheWorst) {
  for (const double bias : {0.0, 1e-9, 0.01, 0.1, 0.5, 1.0, 2.0, 7.99, 8.01, 1e3}) {
    EXPECT_NEAR(covered(half_width_with_bias(1, bias), bias), 0.95, 1e-9) << bias;
    EXPECT_NEAR(half_width_with_bias(1e-7, 1e-7 * bias), 1e-7 * half_width_with_bias(1, bias), 1e-15 * (1 + bias));
  }
}

TEST(HalfWidthWithBias, HasLimits) {
  EXPECT_NEAR(half_width_with_bias(1, 0), 1.959964, 1e-6);
  EXPECT_EQ(half_width_with_bias(0, 0.25), 0.25);
  EXPECT_TRUE(std::isnan(half_width_with_bias(NAN, 1)));
  EXPECT_TRUE(std::isnan(half_width_with_bias(1, NAN)));
  EXPECT_TRUE(std::isnan(half_width_with_bias(INFINITY, INFINITY)));
}

// Of four numbers: three degrees of freedom, whose quantile is 3.182446305284263.
TEST(MeanInterval, OfFewNumbersIsStudents) {
  const std::array few{1.0, 2.0, 3.0, 6.0};
  const auto found = mean_interval(few);
  const double half = 3.182446305284263 * std::sqrt(14 / 3.0 / 4);
  EXPECT_EQ(found.value, 3);
  EXPECT_NEAR(found.low, 3 - half, 1e-12);
  EXPECT_NEAR(found.high, 3 + half, 1e-12);
}

// In any order; beside the law by more below a number than above it, or the other way. The half-width is that of
// Dvoretzky, Kiefer and Wolfowitz, of as many numbers as they are worth.
TEST(KolmogorovSmirnov, DistanceAndIntervalOfNumbersInAnyOrder) {
  const auto uniform = [](double t) { return t; };
  const std::vector<double> x{0.9, 0.35, 0.6, 0.5, 0.95};
  const auto found = ks_distance(x, uniform);
  const double half = std::sqrt(std::log(40) / 10);
  EXPECT_NEAR(found.value, 0.35, 1e-15);  // none below 0.35
  EXPECT_EQ(found.low, 0);
  EXPECT_NEAR(found.high, 0.35 + half, 1e-15);
  const auto worth_more = ks_distance(x, uniform, 50);
  EXPECT_NEAR(worth_more.low, 0.35 - half / std::sqrt(10), 1e-15);
  EXPECT_NEAR(worth_more.high, 0.35 + half / std::sqrt(10), 1e-15);
  EXPECT_NEAR(ks_distance(x, uniform, 0.5).high, 0.35 + half * std::sqrt(10), 1e-15);
  EXPECT_NEAR(ks_distance(std::vector{0.3, 0.1, 0.2}, uniform).value, 0.7, 1e-15);  // all below 0.3
}

// erfc(x / sqrt 2) / 2 is the tail beyond x.
TEST(NormalDeviate, OfNoTailAtAllIsThatOf1e300) {
  EXPECT_NEAR(std::erfc(normal_deviate(0) / std::sqrt(2.0)) / 2 / 1e-300, 1, 1e-10);
  EXPECT_EQ(normal_deviate(1e-301), normal_deviate(0));
}

// Of 1, 2, 4 beside a thousand million: their mean is no binary number, and its rounding is no part of the width.
TEST(MeanInterval, IsThatOfTheDifferencesWhereTheMeanIsLarge) {
  const std::array small{1.0, 2.0, 4.0}, large{1e9 + 1, 1e9 + 2, 1e9 + 4};
  const auto found = mean_interval(large), expected = mean_interval(small);
  EXPECT_NEAR(found.high - found.low, expected.high - expected.low, 1e-6);
  const double quantile = 0.95 / std::sqrt(2 * 0.975 * 0.025);  // of two degrees of freedom
  EXPECT_NEAR(expected.high - expected.low, 2 * quantile * std::sqrt(14 / 3.0 / 2 / 3), 1e-12);
}

// Below the second of three there is one.
TEST(KolmogorovSmirnov, DistanceIsAlsoThatJustBelowANumber) {
  const std::vector<double> x{0.1, 0.8, 0.9};
  EXPECT_NEAR(ks_distance(x, [](double t) { return t; }).value, 0.8 - 1.0 / 3, 1e-15);
}

// P(X >= 0) = 1, P(X >= 1) = 1 - exp(-m), P(X <= 0) = exp(-m).
TEST(Poisson, TailsOfFewCounts) {
  EXPECT_EQ(poisson_upper(0, 0.7), 1);
  EXPECT_NEAR(poisson_upper(1, 0.7), 1 - std::exp(-0.7), 1e-15);
  EXPECT_NEAR(poisson_upper(2, 0.7), 1 - 1.7 * std::exp(-0.7), 1e-15);
  EXPECT_NEAR(poisson_lower(0, 0.7), std::exp(-0.7), 1e-15);
}

}  // namespace
}  // namespace polhode
