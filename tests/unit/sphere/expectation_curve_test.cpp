// SPDX-License-Identifier: Apache-2.0
// Expectations as functions of time within their stated uncertainty, and those of a path without noise.
#include "sphere/expectations/expectation_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "references/free_rotation.hpp"
#include "references/odeint.hpp"
#include "sphere/expectations/deterministic.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

TEST(ExpectationCurve, IsTheExpectationAtEveryTime) {
  const std::vector<sphere_function> functions{observable("energy"), observable("pi1"), observable("pi3")};
  const Eigen::Vector3d scale(0.1, 1, 2);
  const double horizon = 3;
  for (const double accuracy : {1e-2, 1e-5, 1e-9}) {
    const auto curve = expectations(paper(), functions, scale, start, horizon, accuracy);
    EXPECT_EQ(curve.reason(), "");
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double bar = curve.uncertainty()[i];
      EXPECT_GT(bar, 0);
      EXPECT_LE(bar, 10 * accuracy * scale[i]);
      for (const double t : {0.0, 0.07, 0.5, 1.1, 2.9, horizon}) {
        const auto exact = expectation(paper(), functions[static_cast<std::size_t>(i)], start, t, 1e-11);
        EXPECT_NEAR(curve.at(t)[i], *exact.value, bar + exact.uncertainty) << accuracy << ' ' << i << ' ' << t;
      }
    }
  }
}

// |Pi| is not one; before its times and after them the curve stays at its ends.
TEST(ExpectationCurve, OfAnyLengthEndsAtItsEnds) {
  auto p = paper();
  p.radius = 1.7;
  const Eigen::Vector3d from = 1.7 * start;
  const std::vector<sphere_function> functions{observable("pi1")};
  const auto curve = expectations(p, functions, Eigen::VectorXd::Ones(1), from, 2, 1e-9);
  EXPECT_EQ(curve.reason(), "");
  EXPECT_NEAR(curve.at(0)[0], from[0], 1e-8);
  EXPECT_NEAR(curve.at(1.3)[0], *expectation(p, functions[0], from, 1.3, 1e-11).value, 1e-8);
  EXPECT_EQ(curve.at(-1)[0], curve.at(0)[0]);
  EXPECT_EQ(curve.at(2.1)[0], curve.at(2)[0]);
}

TEST(ExpectationCurve, OfTooLongATimeHasNoAnswer) {
  const std::vector<sphere_function> functions{observable("pi1")};
  const auto curve = expectations(paper(), functions, Eigen::VectorXd::Ones(1), start, 1e9, 1e-6);
  EXPECT_EQ(curve.reason(), "no affordable degree answers");
  EXPECT_EQ(curve.uncertainty()[0], HUGE_VAL);
  EXPECT_EQ(curve.at(1)[0], 0);
}

// time (|A| |Pi| + |b|) (1 + theta |Pi|), with the largest eigenvalue of A, wherever its axis is.
TEST(Deterministic, RefusesMoreTurnsThanCanBeFollowed) {
  auto p = problem(0.5, Eigen::Matrix3d::Zero());
  p.radius = 2;
  p.quadratic << 1, 3, 0, 3, 1, 0, 0, 0, 1;
  p.field = {0, 0.6, 0.8};
  const auto found = on_the_path(p, observable("pi1"), {0, 0, 2}, 1e7);
  EXPECT_FALSE(found.value);
  EXPECT_EQ(found.reason, "no noise, and 1.8e+08 turns are too many to follow; at most 1e+07");
}

// The second way: elliptic functions where they apply, the same solver in two pieces where they do not.
TEST(Deterministic, IsAsUncertainAsTwoWaysDiffer) {
  const Eigen::Vector3d from(0.6, 0.48, 0.64);
  const sphere_function f = [](const Eigen::Vector3d& pi) { return pi[0] + 2 * pi[1]; };
  const auto solved = [&](const sphere_problem& p, const Eigen::Vector3d& at, double time) -> Eigen::Vector3d {
    const auto drift = [&](std::span<const double> mu, std::span<double> out) {
      const Eigen::Vector3d pi(mu[0], mu[1], mu[2]), rate = p.rate(pi);
      Eigen::Map<Eigen::Vector3d>(out.data()) = pi.cross(rate + p.damping * pi.cross(rate));
    };
    return Eigen::Vector3d(solve_drift(drift, std::array{at[0], at[1], at[2]}, time).data());
  };
  auto bent = problem(0, Eigen::Matrix3d::Zero());
  bent.quadratic(0, 1) = bent.quadratic(1, 0) = 0.1;
  auto negative = problem(0, Eigen::Matrix3d::Zero());
  negative.quadratic(2, 2) = -0.5;
  auto in_field = problem(0, Eigen::Matrix3d::Zero());
  in_field.field = {0.1, 0, 0};
  const double time = 40;
  for (const auto& p :
       {problem(0, Eigen::Matrix3d::Zero()), problem(0.5, Eigen::Matrix3d::Zero()), bent, negative, in_field}) {
    const bool closed = p.damping == 0 && !p.has_field() && p.quadratic.isDiagonal(0) && p.quadratic(2, 2) > 0;
    const Eigen::Vector3d inertia = p.quadratic.diagonal().cwiseInverse();
    const Eigen::Vector3d other =
        closed ? Eigen::Vector3d(
                     free_rotation({inertia[0], inertia[1], inertia[2]}, {from[0], from[1], from[2]}, time).data())
               : solved(p, solved(p, from, 0.37 * time), 0.63 * time);
    const auto found = on_the_path(p, f, from, time);
    const double value = f(solved(p, from, time));
    EXPECT_EQ(found.value, value);
    EXPECT_DOUBLE_EQ(found.uncertainty, std::max(std::fabs(value - f(other)), 1e-14 * std::max(1.0, std::fabs(value))));
  }
}

// About an axis nothing moves, and two ways of following that agree to the last digit: rounding is left, of one or
// more.
TEST(Deterministic, IsNeverMoreCertainThanRounding) {
  const auto p = problem(0.5, Eigen::Matrix3d::Zero());
  const auto uncertainty_of = [&](double size) {
    const auto found = on_the_path(
        p, [=](const Eigen::Vector3d& pi) { return size * pi[2]; }, Eigen::Vector3d::UnitZ(), 2);
    EXPECT_EQ(found.value, size);
    return found.uncertainty;
  };
  EXPECT_GT(uncertainty_of(1), 1e-16);
  EXPECT_LT(uncertainty_of(1), 1e-9);
  EXPECT_NEAR(uncertainty_of(1e6), 1e6 * uncertainty_of(1), 1e-9 * uncertainty_of(1e6));
  EXPECT_EQ(uncertainty_of(1e-6), uncertainty_of(1));
}

}  // namespace
}  // namespace polhode::test
