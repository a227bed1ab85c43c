// SPDX-License-Identifier: Apache-2.0
// The spectral gap on the sphere: known ones, weak noise, and none where something is conserved.
#include <gtest/gtest.h>

#include <cmath>

#include "sphere/harmonics/backward_operator.hpp"
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

// Every component relaxes by the noise about the two other axes, and nothing is slower.
TEST(SpectralGap, OfARoundBodyIsThatOfItsSlowestComponent) {
  for (const auto& q :
       {Eigen::Vector3d(0.5, 0.2, 0.1), Eigen::Vector3d(0.1, 0.5, 0.2), Eigen::Vector3d(0.2, 0.1, 0.5)}) {
    const auto round = body_on_sphere({2, 2, 2}, 0, 1, q.asDiagonal());
    holds(spectral_gap(round, 1e-12), (0.1 + 0.2) / 2, 1e-13);
  }
}

TEST(SpectralGap, IsTheSameInEveryUnitOfTime) {
  const auto p = problem(0.5, Eigen::Matrix3d::Identity());
  const auto expected = spectral_gap(p, 1e-10);
  ASSERT_TRUE(expected.converged());
  for (const double unit : {std::exp2(-50), std::exp2(50)}) {
    auto other = p;
    other.quadratic *= unit;
    other.covariance *= unit;
    const auto found = spectral_gap(other, 1e-10 * unit);
    ASSERT_TRUE(found.converged()) << found.reason;
    EXPECT_EQ(found.degree, expected.degree);
    EXPECT_NEAR(*found.value, unit * *expected.value, 1e-13 * unit);
  }
}

// About an oblique axis of revolution one block holds all modes, more than are taken whole at the last degree: there
// the slowest mode, which turns about the axis, is far from zero. About a coordinate axis all blocks are small.
TEST(SpectralGap, KeepsAModeThatTurnsFast) {
  const auto about = [](const Eigen::Vector3d& n) {
    const Eigen::Matrix3d along = n * n.transpose();
    return sphere_problem{5e-4 * along, 0, 1, 1e-3 * (Eigen::Matrix3d::Identity() - 0.9 * along), 0.1 * n};
  };
  const auto found = spectral_gap(about(Eigen::Vector3d(1, 2, 2) / 3), 1e-12, 21);
  ASSERT_TRUE(found.converged()) << found.reason;
  EXPECT_EQ(found.degree, 21);
  EXPECT_NEAR(*found.value, *spectral_gap(about(Eigen::Vector3d::UnitZ()), 1e-12, 21).value, 1e-12);
}

// Of a spread of 100 over noise of trace 3 the needed degree is 100 to the last bit.
TEST(SpectralGap, TheAveragedOneIsNamedBeyondANeededDegreeOf100) {
  for (const double spread : {100.0, 100.5}) {
    const sphere_problem p{Eigen::Vector3d(10, 40, 10 + spread).asDiagonal(), 0, 1, Eigen::Matrix3d::Identity()};
    const auto found = spectral_gap(p, 1e-9, 8);
    EXPECT_FALSE(found.converged());
    EXPECT_EQ(needed_degree(p) == 100, spread == 100);
    EXPECT_EQ(found.reason.find("averaging over circles") != std::string::npos, spread > 100) << found.reason;
  }
}

// Its products of rates overflow; then its rates themselves, so that there is no mode at all.
TEST(SpectralGap, BeyondDoublePrecisionIsRefused) {
  for (const auto& [noise, degree] : {std::pair{1e300, 6}, {1e308, 36}}) {
    const sphere_problem p{Eigen::Vector3d(1, 2, 3).asDiagonal(), 0, 1, noise * oblique(), {0.3, -0.2, 0.5}};
    const auto found = spectral_gap(p, 1e-9, degree);
    EXPECT_FALSE(found.value);
    EXPECT_NE(found.reason.find("no affordable degree answers"), std::string::npos) << found.reason;
  }
}

// Without dissipation x^2 - y^2 and z^2 are apart up to degree 2, and joined by xyz from degree 3 on: a block less. Of
// noise about both axes across z the former is then as slow as any, and rounding chooses it.
TEST(SpectralGap, BlocksMayJoinAtAHigherDegree) {
  for (const double q : {0.58, 0.7, 0.85}) {
    const auto gap = [&](const Eigen::Vector3d& turning, const Eigen::Vector3d& noise, int degree) {
      return spectral_gap({(q * turning).asDiagonal(), 0, 1, noise.asDiagonal()}, q, degree);
    };
    const auto found = gap({0.2, 0.5, 2.6}, {q, q, 0}, 6), other = gap({2.6, 0.2, 0.5}, {0, q, q}, 6);
    ASSERT_TRUE(found.value && other.value) << found.reason;
    EXPECT_NEAR(*found.value, *other.value, 1e-13);
    EXPECT_NEAR(*found.value, *gap({0.2, 0.5, 2.6}, {q, q, 0}, 16).value, found.uncertainty);
    EXPECT_FALSE(gap({20, 30, 60}, {q, q, 0}, 6).value);  // not resolved, and the slowest mode is another at degree 4
  }
}

}  // namespace
}  // namespace polhode::test
