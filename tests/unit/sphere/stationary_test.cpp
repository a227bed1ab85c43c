// SPDX-License-Identifier: Apache-2.0
// The stationary law on the sphere: Gibbs, uniform, what a long time gives, and none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/stationary.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

TEST(Stationary, IsTheGibbsLawUnderIsotropicNoise) {
  const auto law = stationary(paper(), 1e-12);
  holds(mean(paper(), law, observable("energy")), 0.27662786228, 1e-11);
  holds(mean(paper(), law, observable("pi1^2")), 0.24176699009, 1e-11);
  holds(mean(paper(), law, observable("pi3^2")), 0.40576662289, 1e-11);
  const auto h = observable("energy");
  const auto second = mean(paper(), law, [&](const Eigen::Vector3d& pi) { return h(pi) * h(pi); });
  EXPECT_NEAR(*second.value - 0.27662786228 * 0.27662786228, 0.00637133262, 2e-11);
  for (const auto& [theta, sigma] : {std::pair{0.5, 0.15}, {2.0, 0.5}}) {
    const auto p = problem(theta, sigma * sigma * Eigen::Matrix3d::Identity());
    const gibbs_law gibbs({1, 2, 3}, 1, 2 * theta / (sigma * sigma));
    holds(mean(p, stationary(p, 1e-11), h), gibbs.mean_energy(), 1e-10);
  }
}

TEST(Stationary, IsUniformWithoutDissipation) {
  const auto p = problem(0, oblique());
  holds(mean(p, stationary(p, 1e-12), observable("energy")), (1 + 1 / 2.0 + 1 / 3.0) / 6, 1e-13);
}

TEST(Stationary, IsWhatALongTimeGivesForAnyNoise) {
  const auto p = problem(0.5, oblique());
  const auto law = stationary(p, 1e-12);
  for (const auto name : {"energy", "pi2", "exp(pi3)"}) {
    const auto late = expectation(p, observable(name), start, 150, 1e-11);
    EXPECT_FALSE(late.forgotten);  // found by the exponential, not by this law
    holds(mean(p, law, observable(name)), *late.value, 1e-10);
  }
}

TEST(Stationary, SaysWhereThereIsNoneOrMany) {
  EXPECT_FALSE(stationary(problem(0.5, Eigen::Matrix3d::Zero()), 1e-9).density);
  // Noise about the figure axis of a body of revolution keeps pi3.
  const auto top = body_on_sphere({2, 2, 3}, 0, 1, Eigen::Vector3d(0, 0, 0.25).asDiagonal());
  const auto law = stationary(top, 1e-9);
  EXPECT_FALSE(law.density);
  EXPECT_NE(law.reason.find("not unique"), std::string::npos);
}

// A law that its last degree changed in one coefficient of pi3, and of which more may be uncertain than that.
TEST(Stationary, AMeanIsAsUncertainAsItsLaw) {
  const auto f = observable("pi3");
  stationary_law law{.density = Eigen::VectorXd::Unit(9, 0), .change = 1e-3 * Eigen::VectorXd::Unit(9, 2), .degree = 2};
  const double effect =
      std::fabs(*mean(paper(), {.density = law.change, .change = 0 * law.change, .degree = 2}, f).value);
  EXPECT_GT(effect, 1e-3);
  for (const double share : {0.5, 1.0, 3.0}) {
    law.uncertainty = share * 1e-3;
    EXPECT_NEAR(mean(paper(), law, f).uncertainty, std::max(1.0, share) * effect, 1e-15) << share;
  }
  law.change.setZero();
  law.uncertainty = 0;
  const double rounding = mean(paper(), law, f).uncertainty;
  EXPECT_GT(rounding, 1e-17);
  EXPECT_LT(rounding, 1e-13);
}

TEST(StationaryMean, BarsHoldAtEveryDegree) {
  for (const auto& q : {Eigen::Matrix3d(0.04 * Eigen::Matrix3d::Identity()), oblique()}) {
    const auto p = problem(0.5, q);
    const auto exact = stationary_mean(p, observable("energy"), 1e-11);
    holds(exact, *mean(p, stationary(p, 1e-11), observable("energy")).value, 1e-10);
    for (const int degree : {1, 4, 6, 8, 12}) {
      const auto rough = stationary_mean(p, observable("energy"), 1e-11, degree);
      if (!rough.value) continue;
      EXPECT_LE(std::fabs(*rough.value - *exact.value), rough.uncertainty + exact.uncertainty) << degree;
    }
  }
}

// A multiple of the Casimir added to h turns nothing; all factors here are powers of two.
TEST(StationaryMean, KeepsItsDigitsNextToSpherical) {
  const double tiny = std::exp2(-30);
  const Eigen::Vector3d differences(0, 1, -0.5), ones = Eigen::Vector3d::Ones();
  const sphere_problem far{differences.asDiagonal(), 2, 1, oblique()};
  const sphere_problem close{(ones + tiny * differences).asDiagonal(), 2, 1, tiny * oblique()};
  for (const auto name : {"pi1^2", "pi2^2", "pi3^2"}) {
    const auto expected = stationary_mean(far, observable(name), 1e-12);
    holds(stationary_mean(close, observable(name), 1e-12), *expected.value, 1e-12);
  }
}

/// E[h] as noise about one axis n grows: s = n.x alone is slow, with D the diffusion that the free motion leaves it,
///   density exp(-theta int h'(s) (1 - s^2) / D ds) = (A_2 + (A_1 - A_2) s^2)^-gamma,   h averaged about n,
///   D = c^2 (1 - s^2) (A_1 s^2 + A_2 (1 - s^2)),   A_1 = |K n across n|^2 / q,   A_2 = |K across n, less trace|^2 / 8
///   q.
double energy_under_strong_noise(const sphere_problem& p, const Eigen::Vector3d& sigma) {
  const Eigen::Vector3d n = sigma.normalized();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - n * n.transpose(), k = across * p.quadratic * across;
  const double q = sigma.squaredNorm(), along = n.dot(p.quadratic * n), rest = k.trace() / 2;
  const double a1 = (across * p.quadratic * n).squaredNorm() / q, a2 = (k - rest * across).squaredNorm() / (8 * q);
  const double gamma = p.damping * (along - rest) / (2 * (a1 - a2));
  double weight = 0, square = 0;
  constexpr int points = 20'000;  // midpoints
  for (int i = 0; i < points; ++i) {
    const double s = (i + 0.5) / points, w = std::pow(1 + (a1 / a2 - 1) * s * s, -gamma);
    weight += w;
    square += w * s * s;
  }
  return p.radius * p.radius / 2 * (rest + (along - rest) * square / weight);
}

// Damping of 1e-15 of the greatest noise entry: it alone tells the law from a uniform one.
TEST(StationaryMean, SeesWeakDampingNextToStrongNoise) {
  struct weakly_damped {
    std::array<double, 3> inertia;
    double damping, radius;
    Eigen::Vector3d sigma;
  };
  for (const auto& [inertia, damping, radius, sigma] :
       {weakly_damped{{2.5, 0.33, 2.5}, 1.2e-6, 0.087, {-160, 78, -227}},
        weakly_damped{{1.75, 2.5, 1.75 + 1e-9}, 1.3e-4, 0.0037, {1.6, 1.3, -15}},
        weakly_damped{{2.1, 0.66, 2.1}, 7.6e-5, 0.0044, {5.6, 3.7, -22}}}) {
    const auto p = body_on_sphere(inertia, damping, radius, sigma * sigma.transpose());
    const double uniform = radius * radius * p.quadratic.trace() / 6, expected = energy_under_strong_noise(p, sigma);
    EXPECT_GT(std::fabs(expected - uniform), 5e-3 * uniform);
    for (const int degree : {24, 36, 48}) {
      const auto found = stationary_mean(p, *named_observable("energy", p), 1e-11 * uniform, degree);
      ASSERT_TRUE(found.value) << found.reason;
      EXPECT_LE(found.uncertainty, 1e-3 * uniform);
      EXPECT_NEAR(*found.value, expected, found.uncertainty + 1e-6 * uniform) << degree;
    }
  }
}

TEST(Stationary, IsUniformToTheDegreeThatIsAskedFor) {
  const auto p = problem(0, oblique());
  EXPECT_EQ(stationary(p, 1e-12, 1).degree, 1);
  EXPECT_EQ(stationary(p, 1e-12, 5).degree, 5);
  EXPECT_EQ(stationary(p, 1e-12, 5).density->size(), 36);
  EXPECT_GT(stationary(p, 1e-12).degree, 1);
}

// |pi_3^2|_2 over the sphere is root 4 pi / 5, and means are counted in root 4 pi.
TEST(StationaryMean, OfAUniformLawIsAsUncertainAsRounding) {
  const auto found = stationary_mean(problem(0, oblique()), observable("pi3^2"), 1e-6);
  EXPECT_NEAR(*found.value, 1.0 / 3, 1e-15);
  EXPECT_NEAR(found.uncertainty, 1e-14 * std::sqrt(1 / 5.0), 1e-20);
}

// By how much the last degree changed it, in proportion to how uncertain the law is; never more certain than rounding.
TEST(Stationary, AMeanIsUncertainInProportionToItsLaw) {
  const double unit = std::sqrt(4 * std::numbers::pi);
  stationary_law law{.density = Eigen::VectorXd::Unit(9, 0) / unit, .change = Eigen::VectorXd::Zero(9), .degree = 2};
  law.change[2] = 0.003;
  law.change[6] = 0.004;
  const auto p = paper();
  const double of_pi3 = std::sqrt(4 * std::numbers::pi / 3);  // its one coefficient
  for (const auto& [uncertainty, beyond] : {std::pair{0.015, 3.0}, {0.001, 1.0}}) {
    law.uncertainty = uncertainty;
    double greatest = 0;
    for (const auto* name : {"pi1", "pi2", "pi3"})
      greatest = std::max(greatest, mean(p, law, observable(name)).uncertainty);
    EXPECT_NEAR(greatest, beyond * 0.003 * of_pi3, 1e-15);
  }
  law.change.setZero();
  EXPECT_NEAR(mean(p, law, observable("pi3")).uncertainty, 0.001 * of_pi3, 1e-15);
  law.uncertainty = 0;
  EXPECT_NEAR(mean(p, law, observable("pi3")).uncertainty, 1e-14 * of_pi3, 1e-20);
}

// Shear 5 = |(3, 4)| over noise of trace 3.75: 20 degrees are needed, and three that agree count from 5 on.
sphere_problem in_need_of_twenty() {
  return {Eigen::Vector3d(1, 2.5, 4).asDiagonal(), 1, 1, 1.25 * Eigen::Matrix3d::Identity(), {0, 1, 0}};
}

TEST(Stationary, ThreeDegreesThatAgreeCountFromAQuarterOfTheNeededOneOn) {
  const auto p = in_need_of_twenty();
  ASSERT_EQ(needed_degree(p), 20);
  EXPECT_EQ(stationary(p, 10, 5).reason, "");
  EXPECT_NE(stationary(p, 10, 4).reason, "");
  EXPECT_LT(stationary(p, 10, 4).uncertainty, 10);
}

TEST(Stationary, HasConvergedAtAnUncertaintyOfItsTolerance) {
  const auto p = in_need_of_twenty();
  const double uncertainty = stationary(p, 0, 12).uncertainty;
  EXPECT_EQ(stationary(p, uncertainty, 12).reason, "");
  EXPECT_NE(stationary(p, std::nextafter(uncertainty, 0), 12).reason, "");
}

/// Noise of strength 10 and dissipation so weak that the density is (1 - beta (h - mean)) / (4 pi): of degree 2, of
/// norm 1 / root 4 pi but for a part of share beta |h - mean| in it.
stationary_law nearly_uniform(double share) {
  const Eigen::Vector3d k(1, 1 / 2.0, 1 / 3.0);
  const double variance = (k.squaredNorm() - k[0] * k[1] - k[1] * k[2] - k[2] * k[0]) / 45;
  const double beta = share / std::sqrt(variance);
  return stationary(problem(beta * 10 / 2, 10 * Eigen::Matrix3d::Identity()), 0, 5);
}

TEST(Stationary, IsAsUncertainAsRoundingAtLeast) {
  EXPECT_NEAR(nearly_uniform(1e-13).uncertainty, 1e-15 / std::sqrt(4 * std::numbers::pi), 1e-24);
}

// From degree 1 to 3 the density changes by that share of itself, after that by its square: uncertain by the power 3/2.
TEST(Stationary, TenRoundingErrorsAreAsGoodAsNone) {
  for (const double errors : {9.5, 10.5}) {
    const auto law = nearly_uniform(std::pow(errors * 1e-15, 2 / 3.0));
    EXPECT_NEAR(law.uncertainty, errors * 1e-15 / std::sqrt(4 * std::numbers::pi), 1e-18);
    EXPECT_EQ(law.reason.empty(), errors < 10) << law.reason;
  }
}

// A function that is whole at the first degree that is tried has its mean there.
TEST(StationaryMean, OfAUniformLawIsFoundByTheFirstDegree) {
  const auto found = stationary_mean(problem(0, oblique()), observable("pi3^2"), 1e-9);
  EXPECT_TRUE(found.converged());
  EXPECT_EQ(found.degree, 8);
}

// z^2 is 1/3 and 2/3 P_2(z): what degree one cuts off is as large as 2/3, and the rounding of one joins it.
TEST(StationaryMean, WhatIsCutOffAndRoundingAddUp) {
  const auto found = stationary_mean(
      problem(0, oblique()), [](const Eigen::Vector3d& pi) { return 1 + 1e-12 * pi[2] * pi[2]; }, 1e-6, 1);
  EXPECT_EQ(found.degree, 1);
  EXPECT_NEAR(found.uncertainty, 1e-12 * 2 / 3 + 1e-14, 2e-15);
}

// Infinite at a point of the quadrature of odd degrees.
TEST(StationaryMean, OfWhatIsInfiniteSomewhereIsRefusedWithoutANeededDegree) {
  const auto found = stationary_mean(
      problem(0, oblique()), [](const Eigen::Vector3d& pi) { return std::log(std::fabs(pi[2])); }, 1e-3, 9);
  EXPECT_FALSE(found.value);
  EXPECT_EQ(found.reason, "not converged to 0.001: no affordable degree answers");
}

// Where three degrees tell more than the proved bound: the change between the first two, over the root mean square of
// the observable, to the power 3/2.
TEST(StationaryMean, DegreesAgreeInUnitsOfTheRootMeanSquare) {
  for (const double noise : {2.0, 5.0}) {
    const auto at = [&](int degree) {  // of degrees 2, 4 and 6
      return stationary_mean(
          problem(1, noise * Eigen::Matrix3d::Identity()), [](const Eigen::Vector3d& pi) { return 7 * pi[2] * pi[2]; },
          1e-18, degree);
    };
    const double change = std::fabs(*at(4).value - *at(2).value), size = 7 / std::sqrt(5);
    const double uncertainty = size * std::pow(change / size, 1.5);
    EXPECT_NEAR(at(6).uncertainty, uncertainty, 1e-8 * uncertainty);
  }
}

TEST(StationaryMean, WithoutNoiseThereIsNoOneLaw) {
  Eigen::Matrix3d tilted;
  tilted << 1, 0.3, -0.2, 0.3, -0.5, 0.1, -0.2, 0.1, 0.2;
  for (const double damping : {0.0, 0.4}) {
    const auto found = stationary_mean({tilted, damping, 1, Eigen::Matrix3d::Zero()}, observable("pi3^2"), 1e-6);
    EXPECT_FALSE(found.value);
    EXPECT_EQ(found.reason, "no noise: every attractor carries a stationary law, and none has a density");
  }
}

}  // namespace
}  // namespace polhode::test
