// SPDX-License-Identifier: Apache-2.0
// Functions on the sphere in harmonics: their quadrature, what is rounding, what a degree cuts off, their unit.
#include "sphere/harmonics/observables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sphere/harmonics/harmonics.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

double wavy(const Eigen::Vector3d& x) { return std::exp(1.7 * x[0] - 0.9 * x[1] + 2.1 * x[2]) + std::sin(5 * x[0]); }

// The function is no polynomial: what is beyond the rule shows in every coefficient.
TEST(HarmonicCoefficients, AreSumsOverTheQuadratureOfTwiceTheDegreeAndTwo) {
  for (const int degree : {0, 3, 4}) {
    const auto rule = sphere_quadrature(2 * degree + 2);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(harmonic_count(degree));
    for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
      const Eigen::Vector3d x = rule.points.row(i);
      sum += rule.weights[i] * wavy(x) * harmonics_at(x, degree);
    }
    EXPECT_LT((harmonic_coefficients(wavy, degree) - sum).norm(), 1e-14 * sum.norm()) << degree;
  }
}

// What is left out as rounding is so in proportion to the rest.
TEST(ObservableCoefficients, ScaleWithTheirFunction) {
  const auto p = problem(0.5, oblique());
  const Eigen::VectorXd expected = observable_coefficients(p, wavy, 5);
  for (const double unit : {std::exp2(-70), std::exp2(70)}) {
    const auto scaled = observable_coefficients(
        p, [&](const Eigen::Vector3d& pi) { return unit * wavy(pi); }, 5);
    EXPECT_EQ(scaled, unit * expected) << unit;
    const auto even = observable_coefficients(
        p, [&](const Eigen::Vector3d& pi) { return unit * pi[2] * pi[2]; }, 5);
    EXPECT_EQ((even.array() != 0).count(), 2) << unit;  // P_0 and P_2 of pi_3
  }
}

// A harmonic of each degree: the next two count by their suprema, root (2l+1)/(4 pi), the third not at all.
TEST(CutTo, CountsTheNextTwoDegrees) {
  const int degree = 3;
  Eigen::VectorXd c = Eigen::VectorXd::Zero(harmonic_count(degree + 3));
  c[harmonic_index(3, -2)] = 0.6;
  c[harmonic_index(4, 1)] = 0.3;
  c[harmonic_index(5, 0)] = 0.2;
  c[harmonic_index(6, -3)] = 0.5;
  const auto p = problem(0.5, oblique());
  const auto cut = cut_to(
      p, [&](const Eigen::Vector3d& x) { return c.dot(harmonics_at(x, degree + 3)); }, degree);
  EXPECT_LT((cut.coefficients - c.head(harmonic_count(degree))).norm(), 1e-14);
  EXPECT_NEAR(cut.cut_off, (0.3 * std::sqrt(9.0) + 0.2 * std::sqrt(11.0)) / std::sqrt(4 * std::numbers::pi), 1e-14);
}

TEST(UnitOf, IsAPowerOfTwoDownTo1em290) {
  EXPECT_EQ(*unit_of(Eigen::Vector3d(0.1, -5.9, 3)), 4);
  EXPECT_EQ(*unit_of(Eigen::Vector3d(0.1, -0.3, 0.2)), 0.25);
  const auto least = unit_of(Eigen::Vector3d(0, -1e-290, 0));
  ASSERT_TRUE(least);
  EXPECT_LE(*least, 1e-290);
  EXPECT_FALSE(unit_of(Eigen::Vector3d(0, std::nextafter(1e-290, 0), 0)));
  EXPECT_FALSE(unit_of(Eigen::Vector3d(1, INFINITY, 0)));
}

}  // namespace
}  // namespace polhode::test
