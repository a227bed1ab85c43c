// SPDX-License-Identifier: Apache-2.0
// A semigroup with a proved bar: where it turns, where it decays, and where following it to its end takes too long.
#include <gtest/gtest.h>

#include <cmath>

#include "sphere/galerkin/propagation.hpp"

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
