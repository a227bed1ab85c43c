// SPDX-License-Identifier: Apache-2.0
// The law of the next state: closed forms of a free rotation under isotropic noise, the expectations of single
// functions, and the law of two intervals in one.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "sphere/expectations/expectation.hpp"
#include "sphere/expectations/transition.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

constexpr double tolerance = 1e-10;

sphere_problem isotropic_body(const std::array<double, 3>& inertia, double damping, double sigma) {
  return body_on_sphere(inertia, damping, 1, sigma * sigma * Eigen::Matrix3d::Identity());
}

sphere_function harmonic(int index) {
  return [=](const Eigen::Vector3d& x) { return harmonics_at(x, 6)[index]; };
}

TEST(Transition, OfIsotropicNoiseAloneDecaysByDegree) {
  const double sigma = 0.7, time = 0.4;
  const auto law = transition(isotropic_body({1, 1, 1}, 0, sigma), time, 6, tolerance);
  for (int l = 0; l <= 6; ++l)
    for (int m = -l; m <= l; ++m) {
      Eigen::VectorXd column = law.columns.col(harmonic_index(l, m));
      EXPECT_NEAR(column[harmonic_index(l, m)], std::exp(-sigma * sigma * l * (l + 1) * time / 2), 1e-13);
      column[harmonic_index(l, m)] = 0;
      EXPECT_LT(column.norm(), 1e-13);
    }
}

TEST(Transition, IsTheExpectationOfEachFunction) {
  const auto problem = isotropic_body({1, 2, 3}, 0.5, 0.5);
  const auto law = transition(problem, 0.3, 3, tolerance);
  EXPECT_TRUE(law.reason.empty());
  const Eigen::VectorXd found = law.columns.transpose() * harmonics_at(start, law.degree);
  for (int i = 1; i < harmonic_count(3); ++i)
    EXPECT_NEAR(found[i], *expectation(problem, harmonic(i), start, 0.3, 1e-12).value, 2 * law.uncertainty + 1e-11);
}

TEST(Transition, OfTwoIntervalsIsTheLawOfBoth) {
  const auto problem = isotropic_body({1, 2, 3}, 0.5, 0.5);
  const auto once = transition(problem, 0.2, 24, 1e-7, 24), both = transition(problem, 0.4, 6, tolerance, 24);
  EXPECT_LT((once.columns * once.columns.leftCols(harmonic_count(6)) - both.columns).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Transition, TakesAnyWantedDegree) {
  for (const int degree : {1, 2, 5}) {
    const auto law = transition(isotropic_body({1, 1, 1}, 0, 0.7), 0.4, 1, tolerance, degree);
    EXPECT_EQ(law.degree, degree);
    EXPECT_NEAR(law.columns(harmonic_index(1, 0), harmonic_index(1, 0)), std::exp(-0.49 * 0.4), 1e-13);
  }
}

TEST(Transition, SaysWhereNoDegreeResolvesIt) {
  EXPECT_FALSE(transition(isotropic_body({1, 2, 3}, 50, 1e-3), 0.1, 1, tolerance).reason.empty());
}

}  // namespace
}  // namespace polhode::test
