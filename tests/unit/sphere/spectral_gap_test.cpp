// SPDX-License-Identifier: Apache-2.0
// The spectral gap on the sphere: known ones, weak noise, and none where something is conserved.
#include <gtest/gtest.h>

#include <cmath>

#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

TEST(SpectralGap, ScenePaperAndSphere) {
  holds(spectral_gap(paper(), 1e-12), 0.23706606686664, 1e-12);  // the independent program, degrees 14 to 20
  const auto round = body_on_sphere({2, 2, 2}, 0, 1, 0.25 * Eigen::Matrix3d::Identity());
  holds(spectral_gap(round, 1e-12), 0.25, 1e-12);
}

// Followed by inverse iteration beyond the dense degrees: the rate at which the last memory of the well fades.
TEST(SpectralGap, IsTheRateAtWhichExpectationsRelax) {
  const auto p = problem(0.5, 0.0144 * Eigen::Matrix3d::Identity());
  const auto gap = spectral_gap(p, 1e-11);
  ASSERT_TRUE(gap.converged()) << gap.reason << ' ' << gap.uncertainty;
  EXPECT_GT(gap.degree, 48);
  const auto at = [&](double t) { return *expectation(p, observable("pi3"), start, t, 1e-12).value; };
  EXPECT_NEAR(std::log(at(150) / at(250)) / 100, *gap.value, 1e-9);
}

TEST(SpectralGap, IsNotClaimedWhereItIsNotResolved) {
  EXPECT_FALSE(spectral_gap(problem(0.5, 0.0025 * Eigen::Matrix3d::Identity()), 1e-9).converged());
}

// Without dissipation h is an eigenfunction at every degree, of rate 3 sigma^2: it hid the slower odd mode, whose rate
// tends to 1.884 sigma^2 as the noise fades (diffusion averaged over the circles of equal energy).
TEST(SpectralGap, OddModeIsSlowerThanTheEnergyUnderWeakNoise) {
  double last = 0;
  for (const double sigma : {0.3, 0.2, 0.1}) {
    const auto gap = spectral_gap(problem(0, sigma * sigma * Eigen::Matrix3d::Identity()), 1e-9);
    ASSERT_TRUE(gap.converged()) << gap.reason;
    const double share = *gap.value / (sigma * sigma);
    EXPECT_GT(share, last);
    EXPECT_LT(share, 1.884);
    last = share;
  }
  EXPECT_NEAR(last, 1.5125744, 1e-6);  // dense, degree 48
}

TEST(SpectralGap, FaintNoiseIsRefusedWithTheDegreeItWouldTake) {
  for (const double sigma : {0.005, 0.001}) {
    const auto gap = spectral_gap(problem(0, sigma * sigma * Eigen::Matrix3d::Identity()), 1e-9);
    EXPECT_FALSE(gap.converged());
    EXPECT_NE(gap.reason.find(sigma > 0.002 ? "about 1600 would" : "about 8200 would"), std::string::npos)
        << gap.reason;
  }
}

// Every truncation has a null vector there, and it changes with the degree.
TEST(SpectralGap, IsZeroOnlyWhereSomethingIsConserved) {
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = 0.5 * Eigen::Vector3d::Unit(k);
    const auto gap = spectral_gap(problem(0, axis * axis.transpose()), 1e-9);
    EXPECT_FALSE(gap.value);
    EXPECT_NE(gap.reason.find("rests for ever"), std::string::npos) << gap.reason;
    EXPECT_FALSE(stationary(problem(0.5, axis * axis.transpose()), 1e-9).density);
  }
  const Eigen::Matrix3d figure = Eigen::Vector3d(0, 0, 0.25).asDiagonal();
  EXPECT_EQ(*spectral_gap(body_on_sphere({2, 2, 3}, 0, 1, figure), 1e-9).value, 0);
  EXPECT_EQ(*spectral_gap(body_on_sphere({2, 2, 2}, 0.5, 1, figure), 1e-9).value, 0);
  EXPECT_FALSE(spectral_gap(body_on_sphere({2, 2, 3}, 0.5, 1, figure), 1e-9).converged());  // damped: not conserved
}

}  // namespace
}  // namespace polhode::test
