// SPDX-License-Identifier: Apache-2.0
// The elementary functions of a step against the standard library in extended precision, and lane for lane.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <polhode/scalar.hpp>
#include <polhode/simd.hpp>

namespace polhode {
namespace {

constexpr double place = 0x1p-52;  // of a number between one and two

/// Times `place` of the result, or of one for results that are sums of parts of that size.
void expect_to_the_last_place(double found, long double expected, double x) {
  const auto size = std::max(std::numeric_limits<double>::min(), static_cast<double>(std::fabs(expected)));
  const double unit = std::exp2(std::floor(std::log2(size))) * place;
  EXPECT_LE(std::fabs(static_cast<double>(found - expected)), unit) << x;
}

template <class Check>
void over(double low, double high, int count, Check check) {
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> uniform(low, high);
  for (int i = 0; i < count; ++i) check(uniform(bits));
  check(low);
  check(high);
}

void check_sincos(double x) {
  const auto [sin, cos] = sincos(x);
  EXPECT_LE(std::fabs(static_cast<double>(sin - std::sin(static_cast<long double>(x)))), place) << x;
  EXPECT_LE(std::fabs(static_cast<double>(cos - std::cos(static_cast<long double>(x)))), place) << x;
  const auto packed = sincos(pack(x));
  EXPECT_EQ(packed.sin[0], sin) << x;
  EXPECT_EQ(packed.cos[0], cos) << x;
}

TEST(Scalar, SineAndCosineAreGoodToTheLastPlace) {
  over(-0.785, 0.785, 20'000, [](double x) {
    check_sincos(x);
    expect_to_the_last_place(sincos(x).sin, std::sin(static_cast<long double>(x)), x);
  });
  over(-10, 10, 20'000, check_sincos);
  over(-1e5, 1e5, 20'000, check_sincos);
  for (const double x : {0.0, 1e-300, 0.785, std::nextafter(0.785, 1), 1e5, 1.0001e5, 1e10, 1e300, -1e300})
    check_sincos(x);
}

void check_exponential(double x) {
  expect_to_the_last_place(exponential(x), std::exp(static_cast<long double>(x)), x);
  EXPECT_EQ(exponential(pack(x))[0], exponential(x));
}

TEST(Scalar, ExponentialIsGoodToTheLastPlace) {
  over(-708, 709, 40'000, check_exponential);
  over(-1, 1, 20'000, check_exponential);
  EXPECT_EQ(exponential(0.0), 1.0);
}

TEST(Scalar, ExponentialLeavesNormalNumbersForZeroAndInfinity) {
  for (const double x : {-708.00001, -708.3, -709.0, -1e6, -1e300}) EXPECT_EQ(exponential(x), 0.0) << x;
  for (const double x : {709.00001, 709.3, 710.0, 1e6, 1e300}) EXPECT_EQ(exponential(x), INFINITY) << x;
}

void check_logarithm(double x) {
  expect_to_the_last_place(logarithm(x), std::log(static_cast<long double>(x)), x);
  EXPECT_EQ(logarithm(pack(x))[0], logarithm(x));
}

TEST(Scalar, LogarithmIsGoodToTheLastPlace) {
  over(0.5, 2, 40'000, check_logarithm);
  over(-1022, 1023, 20'000, [](double power) { check_logarithm(std::exp2(power)); });
  EXPECT_EQ(logarithm(1.0), 0.0);
  check_logarithm(std::numeric_limits<double>::min());
  check_logarithm(std::numeric_limits<double>::max());
}

TEST(Scalar, FloatsAreRoundedFromDoubles) {
  for (const float x : {0.3f, 2.5f, 40.0f}) {
    EXPECT_EQ(logarithm(x), static_cast<float>(logarithm(static_cast<double>(x))));
    EXPECT_EQ(exponential(x), static_cast<float>(exponential(static_cast<double>(x))));
    EXPECT_EQ(sincos(x).sin, static_cast<float>(sincos(static_cast<double>(x)).sin));
    EXPECT_EQ(sincos(x).cos, static_cast<float>(sincos(static_cast<double>(x)).cos));
  }
}

TEST(Scalar, WhatNumbersDoPacksDoLaneByLane) {
  pack x;
  for (std::size_t lane = 0; lane < pack::size(); ++lane) x[lane] = static_cast<double>(lane) - 1.5;
  const pack size = magnitude(x), root = square_root(size), chosen = select(x > pack(0.0), pack(1.0), x);
  for (std::size_t lane = 0; lane < pack::size(); ++lane) {
    EXPECT_EQ(size[lane], magnitude(static_cast<double>(x[lane])));
    EXPECT_EQ(root[lane], square_root(static_cast<double>(size[lane])));
    EXPECT_EQ(chosen[lane], select(x[lane] > 0, 1.0, static_cast<double>(x[lane])));
  }
  EXPECT_TRUE(any(x, x < pack(0.0)));
  EXPECT_FALSE(any(x, x < pack(-2.0)));
  EXPECT_TRUE(any(1.0, true));
  EXPECT_FALSE(any(1.0, false));
}

}  // namespace
}  // namespace polhode
