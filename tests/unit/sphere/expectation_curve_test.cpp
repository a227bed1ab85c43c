// SPDX-License-Identifier: Apache-2.0
// Expectations as functions of time within their stated uncertainty, and those of a path without noise.
#include "sphere/expectations/expectation_curve.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>
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

// exp(-s t) has the coefficients 2 (-1)^k exp(-a) I_k(a), a = s T / 2; those beyond the last node are folded back. With
// as many nodes as that takes the last eighth of them is the bar, and nothing else is uncertain.
TEST(ExpectationCurve, IsAsUncertainAsItsLastCoefficients) {
  for (const auto& [a, nodes] : {std::pair{6.0, 16}, {20.0, 32}}) {
    const auto round = body_on_sphere({1, 1, 1}, 0, 1, Eigen::Matrix3d::Identity());
    const std::vector<sphere_function> functions{observable("pi1")};
    const auto curve = expectations(round, functions, Eigen::VectorXd::Ones(1), start, 2 * a, 1e-6);
    EXPECT_EQ(curve.reason(), "");
    const auto coefficient = [&](int k) { return 2 * std::exp(-a) * boost::math::cyl_bessel_i(k, a) * start[0]; };
    double tail = coefficient(nodes);
    for (int k = nodes - nodes / 8 + 1; k < nodes; ++k) tail += coefficient(k) + coefficient(2 * nodes - k);
    EXPECT_GT(tail, 1e-10);
    EXPECT_NEAR(curve.uncertainty()[0], tail, 1e-12) << a;
    for (int j = 0; j <= nodes; ++j) {  // at its nodes it is exact
      const double t = a * (1 - std::cos(std::numbers::pi * j / nodes));
      EXPECT_NEAR(curve.at(t)[0], std::exp(-t) * start[0], 1e-13) << j;
    }
  }
}

// About the field it turns more often than the nodes can follow: c_k = 2 J_k(a) Re[(-i)^k exp(ia) (Pi_1 - i Pi_2)], a
// the turns by half the time, again folded back at the last node.
TEST(ExpectationCurve, OfTooManyTurnsSaysWhatItIsKnownTo) {
  const sphere_problem spin{Eigen::Matrix3d::Zero(), 0, 1, 1e-14 * Eigen::Matrix3d::Identity(), {0, 0, 2}};
  const double a = 865;
  const int nodes = 1024;
  const auto coefficient = [&](int k) {
    const double angle = a - k * std::numbers::pi / 2;
    return 2 * boost::math::cyl_bessel_j(k, a) * (std::cos(angle) * start[0] + std::sin(angle) * start[1]);
  };
  double tail = std::fabs(coefficient(nodes));
  for (int k = nodes - nodes / 8 + 1; k < nodes; ++k) tail += std::fabs(coefficient(k) + coefficient(2 * nodes - k));
  EXPECT_GT(tail, 1e-6);
  const std::vector<sphere_function> functions{observable("pi1")};
  const double scale = 4;
  const auto curve = expectations(spin, functions, Eigen::VectorXd::Constant(1, scale), start, a, tail / scale / 10.5);
  EXPECT_EQ(curve.reason(),
            fmt::format("known to {:.1e} of an observable's size only", curve.uncertainty()[0] / scale));
  EXPECT_NEAR(curve.uncertainty()[0], tail, 0.01 * tail);  // to ten times the accuracy it would do
}

// A multiple of one added to the quadratic form turns nothing: a body that is, as a reference, one of inertia.
TEST(Deterministic, FollowsABodyOfWhichOneInertiaIsInfinite) {
  auto p = problem(0, Eigen::Matrix3d::Zero());
  p.quadratic = Eigen::Vector3d(1, 0.5, 0).asDiagonal();
  const double time = 3;
  const auto turned = free_rotation({1 / 2.0, 1 / 1.5, 1}, {start[0], start[1], start[2]}, time);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto found = on_the_path(
        p, [=](const Eigen::Vector3d& pi) { return pi[static_cast<Eigen::Index>(axis)]; }, start, time);
    EXPECT_NEAR(*found.value, turned[axis], 1e-12) << axis;
    EXPECT_LT(found.uncertainty, 1e-12) << axis;
  }
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

// At the start degree 12 is off by 4e-7, and the next by less. The change from 8 to 12 is below the accuracy asked
// already; that the one after it is as well is waited for.
TEST(ExpectationCurve, TakesTwoChangesInARowToBeSmall) {
  const auto round = body_on_sphere({1, 1, 1}, 0, 1, 0.01 * Eigen::Matrix3d::Identity());
  const std::vector<sphere_function> functions{[](const Eigen::Vector3d& x) { return std::exp(6 * (x[2] - 1)); }};
  const auto curve = expectations(round, functions, Eigen::VectorXd::Ones(1), start, 1, 0.03);
  EXPECT_EQ(curve.reason(), "");
  EXPECT_NEAR(curve.at(0)[0], functions[0](start), 1e-7);
}

// With so many turns in that time all nodes of a few see one value nearly; the horizon is one of them.
TEST(ExpectationCurve, IsNotDeceivedByNodesThatSeeAFastTurnAsSlow) {
  const sphere_problem spin{Eigen::Matrix3d::Zero(), 0, 1, 1e-4 * Eigen::Matrix3d::Identity(), {0, 0, 2}};
  const std::vector<sphere_function> functions{observable("pi1")};
  const Eigen::Vector3d from(0.6, 0.48, 0.64);
  for (const double time : {100.0, 700.0, 1050.0}) {
    const auto curve = expectations(spin, functions, Eigen::VectorXd::Ones(1), from, time, 1e-2);
    double most = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = time * i / 1000.0;
      most = std::max(
          most, std::fabs(curve.at(t)[0] - std::exp(-1e-4 * t) * (0.6 * std::cos(2 * t) + 0.48 * std::sin(2 * t))));
    }
    EXPECT_LE(most, curve.uncertainty()[0] + 1e-12) << time;
  }
}

}  // namespace
}  // namespace polhode::test
