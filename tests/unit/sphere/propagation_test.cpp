// SPDX-License-Identifier: Apache-2.0
// A semigroup with a proved bar: where it turns, where it decays, and where following it to its end takes too long.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sphere/galerkin/poisson.hpp"
#include "sphere/galerkin/propagation.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/harmonics/observables.hpp"

namespace polhode {
namespace {

/// On a constant and two functions that turn into each other and decay, and so much of the second in one beyond them.
sparse_matrix generator(double turning, double decay, double beyond = 0) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(4, 3);
  a(1, 1) = a(2, 2) = -decay;
  a(1, 2) = -turning;
  a(2, 1) = turning;
  a(3, 2) = beyond;
  return a.sparseView();
}

std::optional<propagated_value> value(const sparse_matrix& a, double time) {
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<1>(); };
  return propagated(a, Eigen::Vector3d(0.5, 1, 0), Eigen::Vector3d(1, 1, 0), time, {size, size, 1});
}

TEST(Propagation, FollowsTheExponential) {
  for (const double time : {0.1, 3.0}) {
    const auto found = value(generator(2, 0.3), time);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->relaxed);
    EXPECT_NEAR(found->found.value, 0.5 + std::exp(-0.3 * time) * std::cos(2 * time), 1e-13);
    EXPECT_LT(found->found.bound, 1e-12);
    EXPECT_GE(found->found.bound, found->found.floor);
  }
}

TEST(Propagation, EndsWhereOnlyTheConstantIsLeft) {
  for (const double time : {200.0, 1e12}) {
    const auto found = value(generator(2, 0.3), time);
    ASSERT_TRUE(found) << time;
    EXPECT_TRUE(found->relaxed) << time;
    EXPECT_NEAR(found->found.value, 0.5, 1e-14) << time;
    EXPECT_LT(found->found.bound, 1e-12) << time;
  }
}

// A constant is one at once, but it was not forgotten before its time.
TEST(Propagation, OfAConstantIsTheConstant) {
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<1>(); };
  const auto found =
      propagated(generator(2, 0.3), Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(1, 1, 0), 3, {size, size, 1});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->found.value, 0.5);
  EXPECT_FALSE(found->relaxed);
}

// Rounding of so many sums of f, as means are counted; beyond a hundred steps by the root of their number.
TEST(Propagation, IsAsUncertainAsRounding) {
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<1>(); };
  const auto floor = [&](double time, double unit) {
    const Eigen::Vector3d f(0.5, 1, 0);
    return propagated(generator(2, 0), f, Eigen::Vector3d(1, 1, 0), time, {size, size, unit})->found.floor;
  };
  const double least = rounding_of_sums * std::sqrt(1.25);
  EXPECT_DOUBLE_EQ(floor(0.5, 1), least);
  EXPECT_DOUBLE_EQ(floor(0.5, 2), least / 2);
  EXPECT_GT(floor(1e5, 1), 1.1 * least);
  EXPECT_NEAR(floor(4e5, 1) / floor(1e5, 1), 2, 0.02);
}

// The steps are those after which it was asked how far the function is from a constant.
TEST(Propagation, IsAsUncertainAsTheRootOfItsSteps) {
  int steps = 0;
  double apart = 0;
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<1>(); };
  const auto asked = [&](const Eigen::VectorXd& v) {
    ++steps;
    return apart = size(v);
  };
  const Eigen::Vector3d f(0.5, 1, 0), y(1, 1, 0);
  const double least = rounding_of_sums * std::sqrt(1.25);
  const auto turning = propagated(generator(2, 0), f, y, 1000, {asked, size, 1});
  EXPECT_GT(steps, 110);
  EXPECT_DOUBLE_EQ(turning->found.floor, least * std::sqrt(steps) / 10);
  EXPECT_DOUBLE_EQ(turning->found.bound, turning->found.floor);
  // What is left of it when it is taken for a constant counts twice: of the value, and of the constant.
  const auto relaxed = propagated(generator(2, 0.3), f, y, 400, {asked, size, 1});
  EXPECT_TRUE(relaxed->relaxed);
  EXPECT_GT(apart, 0.01 * least);
  EXPECT_NEAR(relaxed->found.bound / relaxed->found.floor, 1 + 2 * apart / relaxed->found.floor, 1e-12);
}

// A u = f - m solved by hand; what the second function has beyond the three is the remainder.
TEST(PoissonMean, HasTheRemainderAsItsBoundAndRoundingAsItsFloor) {
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<1>(); };
  const double turning = 2, decay = 0.3, beyond = 0.01, square = turning * turning + decay * decay;
  const double u1 = decay / square, u2 = turning / square;  // both negative
  const Eigen::Vector3d f(-0.5, 1, 0);
  const auto found = poisson_mean(generator(turning, decay, beyond), f, 3, size);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, -0.5);
  const double sizes = (decay + turning) * (u1 + u2) + beyond * u2;
  EXPECT_NEAR(found->floor, std::numeric_limits<double>::epsilon() * (sizes + 0.5), 1e-24);
  EXPECT_NEAR(found->bound, beyond * u2 + found->floor, 1e-15);
  const auto exact = poisson_mean(generator(0, 0.5), f, 3, size);
  EXPECT_EQ(exact->bound, exact->floor);
  EXPECT_GT(exact->floor, 0);
  EXPECT_FALSE(poisson_mean(generator(turning, decay, beyond), f, 2, size));
  EXPECT_FALSE(poisson_mean(generator(0, 0), f, 3, size));  // singular
}

// A zonal harmonic is greatest at the pole, where its bound is reached.
TEST(HarmonicSupremum, IsReachedByAHarmonicOfOneDegree) {
  for (int l = 0; l <= 6; ++l) {
    const Eigen::VectorXd at_the_pole = harmonics_at({0, 0, 1}, l);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(harmonic_count(l));
    f[harmonic_index(l, 0)] = -2;
    EXPECT_NEAR(harmonic_supremum(f), 2 * at_the_pole[harmonic_index(l, 0)], 1e-14);
    EXPECT_NEAR(harmonic_supremum(f.tail(2 * l + 1), l), 2 * at_the_pole[harmonic_index(l, 0)], 1e-14);
  }
  const Eigen::Vector4d f(1, 2, -3, 6);
  EXPECT_NEAR(harmonic_supremum(f), (1 + std::sqrt(3.0) * 7) / std::sqrt(4 * std::numbers::pi), 1e-14);
}

// Many functions, as its limit is one of multiplications.
TEST(Propagation, GivesUpWhereItTurnsForever) {
  constexpr int pairs = 1000;
  sparse_matrix a(2 * pairs + 2, 2 * pairs + 1);
  for (int i = 1; i < 2 * pairs; i += 2) {
    a.insert(i, i + 1) = -2;
    a.insert(i + 1, i) = 2;
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(2 * pairs + 1);
  const auto size = [](const Eigen::VectorXd& v) { return v.lpNorm<1>(); };
  EXPECT_FALSE(propagated(a, ones, ones, 1e12, {size, size, 1}));
}

// By how much of the second function is there at most, over the time: |sin| from 0 to where it is 1, or less.
TEST(Propagation, WhatLeavesTheFunctionsIsItsBar) {
  const double time = 0.5, beyond = 0.01, left = beyond * (1 - std::cos(2 * time)) / 2;
  const auto found = value(generator(2, 0, beyond), time);
  ASSERT_TRUE(found);
  EXPECT_GE(found->found.bound, left);
  EXPECT_LE(found->found.bound, beyond * time);
}

}  // namespace
}  // namespace polhode
