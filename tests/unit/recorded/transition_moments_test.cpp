// SPDX-License-Identifier: Apache-2.0
// What one transition adds to the sums of the transition test, by single expectations; and what the test makes of sums
// that are given.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "recorded/transition_moments.hpp"
#include "recorded/transition_test.hpp"
#include "sphere/expectations/expectation.hpp"

namespace polhode::test {
namespace {

constexpr double tolerance = 1e-10;

sphere_function harmonic(int index) {
  return [=](const Eigen::Vector3d& x) { return harmonics_at(x, 6)[index]; };
}

const Eigen::Vector3d somewhere = Eigen::Vector3d(0.6, 0.48, 0.64), elsewhere = Eigen::Vector3d(-0.36, 0.8, -0.48);

TEST(TransitionMoments, HaveTheConditionalMeanAndVarianceOfEachTest) {
  const auto problem = body_on_sphere({1, 2, 3}, 0.5, 1, 0.25 * Eigen::Matrix3d::Identity());
  transition_moments moments(transition(problem, 0.3, 2 * degree_after, tolerance));
  moments.add(somewhere, elsewhere);
  const auto& sums = moments.sums();
  const auto y = sums.residual(moments.law().columns);
  const Eigen::VectorXd before = harmonics_at(somewhere, degree_before), after = harmonics_at(elsewhere, degree_after);
  for (int f = 1; f <= functions_after; ++f) {
    const double mean = *expectation(problem, harmonic(f), somewhere, 0.3, 1e-12).value;
    const double second =
        *expectation(
             problem, [&](const Eigen::Vector3d& x) { return std::pow(harmonic(f)(x), 2); }, somewhere, 0.3, 1e-12)
             .value;
    for (int g = 0; g < functions_before; ++g) {
      const int test = g * functions_after + f - 1;
      EXPECT_NEAR(y[test], (after[f] - mean) * before[g], 1e-9);
      EXPECT_NEAR(sums.variance(test, test), (second - mean * mean) * before[g] * before[g], 1e-9);
      EXPECT_NEAR(sums.observed(test, test), y[test] * y[test], 1e-9);
    }
  }
}

TEST(TransitionTest, CountsTheDegreesOfFreedomThatThereAre) {
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(all_tests);
  Eigen::MatrixXd variance = Eigen::MatrixXd::Identity(all_tests, all_tests);
  residual[5] = 5;
  const auto healthy = test_transitions(residual, variance, 1e5);
  EXPECT_EQ(healthy.rank, all_tests);
  EXPECT_DOUBLE_EQ(healthy.largest, 5);
  EXPECT_NEAR(healthy.squares, 25, 1e-12);
  EXPECT_NEAR(healthy.p_largest, 2 * all_tests * 2.866515718791933e-07, 1e-12);  // 2 (1 - Phi(5)) a test
  EXPECT_TRUE(healthy.refuted());                                                // 7.7e-5 of 5e-4
  variance.row(5) = variance.row(6);  // the same test twice: one direction less
  variance.col(5) = variance.col(6);
  variance(5, 5) = 1;
  residual[6] = 5;
  EXPECT_EQ(test_transitions(residual, variance, 1e5).rank, all_tests - 1);
  EXPECT_EQ(test_transitions(residual, variance, 1e3).family.tests(), 12);  // 40 transitions a test
  EXPECT_EQ(test_transitions(residual, variance, 100).family.tests(), 0);
}

}  // namespace
}  // namespace polhode::test
