// SPDX-License-Identifier: Apache-2.0
// Observables next to the ends of double precision: squares of them overflowed or vanished, and 0 +- 0 was the answer.
#include <gtest/gtest.h>

#include <cmath>

#include "sphere/expectations/expectation.hpp"
#include "sphere/stationary.hpp"

namespace polhode::test {
namespace {

const std::array<double, 3> inertia{1, 2, 3};

sphere_problem loud(double radius) { return body_on_sphere({2, 2, 2}, 0, radius, Eigen::Matrix3d::Identity()); }

void expect_to_be(const reference_value& found, double truth) {
  ASSERT_TRUE(found.value) << found.reason;
  EXPECT_LE(std::fabs(*found.value / truth - 1), found.uncertainty / truth);
  EXPECT_GT(found.uncertainty, 1e-16 * truth);
  EXPECT_LT(found.uncertainty, 0.02 * truth);
}

TEST(ObservableUnit, ExponentialsOnALargeSphere) {  // uniform law: sinh(c) / c
  const auto f = *named_observable("exp(pi3)", loud(1));
  for (const double c : {1.0, 400.0}) {
    const auto p = loud(c);
    const double truth = -std::expm1(-2 * c) * std::exp(c - std::log(2 * c));
    expect_to_be(stationary_mean(p, f, 0.01 * truth), truth);
    expect_to_be(expectation(p, f, {0, 0, c}, 100, 0.01 * truth), truth);
  }
}

TEST(ObservableUnit, EnergyOnATinySphere) {  // m + (h0 - m) exp(-3 sigma^2 t), m = c^2 tr(1 / I) / 6
  const auto f = *named_observable("energy", body_on_sphere(inertia, 0, 1, Eigen::Matrix3d::Zero()));
  for (const double c : {1e-3, 1e-90, 1e-140}) {
    auto p = loud(c);
    p.quadratic = body_on_sphere(inertia, 0, c, p.covariance).quadratic;
    const Eigen::Vector3d start(0.6 * c, 0.48 * c, 0.64 * c);
    const double mean = c * c * (1 + 1.0 / 2 + 1.0 / 3) / 6, t = 0.5;
    expect_to_be(stationary_mean(p, f, 1e-11 * mean), mean);
    expect_to_be(expectation(p, f, start, t, 1e-11 * mean), mean + (f(start) - mean) * std::exp(-3 * t));
  }
}

TEST(ObservableUnit, BeyondDoublePrecisionIsRefused) {
  const auto refused = [](const char* name, double c) {
    const auto f = *named_observable(name, body_on_sphere(inertia, 0, 1, Eigen::Matrix3d::Zero()));
    for (const auto& found : {stationary_mean(loud(c), f, 0), expectation(loud(c), f, {0, 0, c}, 1, 0)}) {
      EXPECT_FALSE(found.value) << name;
      EXPECT_NE(found.reason.find("another unit of momentum"), std::string::npos) << found.reason;
    }
  };
  refused("exp(pi3)", 1000);
  refused("energy", 1e-170);
  refused("pi1^2", 1e160);
}

}  // namespace
}  // namespace polhode::test
