// SPDX-License-Identifier: Apache-2.0
// `polhode reference` as a function: what an independent program printed, and closed forms.
#include "run/reference.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "sphere/harmonics/harmonics.hpp"
#include "support/dense.hpp"
#include "unit/run/reference_questions.hpp"

namespace polhode::test {
namespace {

TEST(Reference, KnownExpectations) {
  const std::vector<std::pair<const char*, double>> known{{"energy", 0.281221439758},
                                                          {"pi1", 0.22605229629},
                                                          {"pi2", 0.44478743232},
                                                          {"pi3", 0.32280817976},
                                                          {"exp(pi3)", 1.55190822842}};
  for (const auto& [name, value] : known)
    EXPECT_NEAR(ask(load_scene("paper"), {"expectation", name, {}, 0}).value, value, 6e-12) << name;
}

TEST(Reference, KnownStationaryMeansAndGap) {
  const auto paper = load_scene("paper");
  for (const int degree : {0, 32}) {
    EXPECT_NEAR(stationary_mean(paper, "energy", degree), 0.27662786228, 6e-12);
    EXPECT_NEAR(stationary_mean(paper, "pi1^2", degree), 0.24176699009, 6e-12);
    EXPECT_NEAR(stationary_mean(paper, "pi3^2", degree), 0.40576662289, 6e-12);
  }
  EXPECT_NEAR(gap(paper), 0.237066066867, 6e-13);
}

TEST(Reference, KnownExponents) {
  const auto a = exponents(load_scene("paper"));
  EXPECT_NEAR(a.value, 0.020196, 6e-7);
  EXPECT_NEAR(*a.sum, -0.0867830798, 6e-11);
  EXPECT_NEAR(*a.dimension, 1 + 0.020196 / (0.0867830798 + 0.020196), 6e-6);
  const auto quiet = exponents(scene_of({1, 2, 3}, 1, half));
  EXPECT_NEAR(quiet.value, -0.04358, 6e-6);
  EXPECT_EQ(*quiet.dimension, 0);
}

TEST(Reference, ASphericalBodyForgetsItsMomentumByTheNoiseAlone) {
  for (const auto& sigma : {half, axes(0.2, 0.5, 0.9), two_vectors}) {
    Eigen::Matrix3d decay = Eigen::Matrix3d::Zero();  // Ito's drift: half of (Pi x sigma) x sigma
    for (const auto& v : sigma) {
      const Eigen::Vector3d e(v[0], v[1], v[2]);
      decay += 0.5 * (e * e.transpose() - e.squaredNorm() * Eigen::Matrix3d::Identity());
    }
    const auto s = scene_of({2, 2, 2}, 0.5, sigma);
    const Eigen::Vector3d mean = test::exponential_of(1.7 * decay) * Eigen::Vector3d(0.6, 0.48, 0.64);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(expected(s, std::array{"pi1", "pi2", "pi3"}[static_cast<std::size_t>(k)], 1.7), mean[k], 1e-12);
  }
}

TEST(Reference, ABodyOfRevolutionKeepsOrLosesItsFigureAxisByTheNoiseAlone) {
  const auto top = scene_of({1, 1, 2.5}, 0, half);
  for (const double t : {0.0, 0.4, 3.0}) {
    const double square = 1 / 3.0 + std::exp(-0.75 * t) * (0.64 * 0.64 - 1 / 3.0);
    EXPECT_NEAR(expected(top, "pi3", t), std::exp(-0.25 * t) * 0.64, 1e-13);
    EXPECT_NEAR(expected(top, "pi3^2", t), square, 1e-13);
    EXPECT_NEAR(expected(top, "energy", t), 0.5 * (1 - square) + square / 5, 1e-13);
  }
  EXPECT_NEAR(gap(top), 0.25, 1e-12);
  // Noise about the figure axis: the precession goes on, its phase diffuses.
  const auto phase = scene_of({1, 1, 2.5}, 0, {{0, 0, 0.4}});
  const double angle = 2 * 0.64 * (1 - 1 / 2.5), faded = std::exp(-0.16);
  EXPECT_NEAR(expected(phase, "pi1", 2), faded * (0.6 * std::cos(angle) - 0.48 * std::sin(angle)), 1e-12);
  EXPECT_NEAR(expected(phase, "pi2", 2), faded * (0.6 * std::sin(angle) + 0.48 * std::cos(angle)), 1e-12);
  EXPECT_EQ(gap(phase), 0);
}

// The Gibbs density summed over the sphere, for extreme bodies too.
TEST(Reference, IsotropicNoiseLeavesTheGibbsLaw) {
  const auto rule = sphere_quadrature(160);
  for (const auto& s : {kinds[0], kinds[2], kinds[6], scene_of({0.5, 4, 0.6}, 0.2, half, 2)}) {
    const double c = std::hypot(s.momentum[0], s.momentum[1], s.momentum[2]), sigma = s.vectors("sigma")[0][0];
    const Eigen::Array3d i(s.vector("inertia").data());
    const Eigen::ArrayXd h = 0.5 * c * c * (rule.points.array().square().matrix() * i.inverse().matrix()).array();
    const Eigen::ArrayXd weight =
        rule.weights.array() * (-2 * s.number("theta") / (sigma * sigma) * (h - h.minCoeff())).exp();
    const double mean = (weight * h).sum() / weight.sum();
    const double second = (weight * rule.points.col(1).array().square()).sum() / weight.sum() * c * c;
    EXPECT_NEAR(stationary_mean(s, "energy"), mean, 1e-10);
    EXPECT_NEAR(stationary_mean(s, "pi2^2"), second, 1e-9);
    EXPECT_NEAR(stationary_mean(s, "energy", 40), mean, 1e-9);
    const auto a = exponents(s);
    EXPECT_NEAR(*a.sum, -s.number("theta") * (c * c * i.inverse().sum() - 6 * mean), 1e-8);
  }
}

TEST(Reference, WithoutDissipationTheLawIsUniformForAnyNoise) {
  for (const auto& sigma : {half, axes(0.2, 0.5, 0.9), two_vectors}) {
    const auto s = scene_of({1, 2, 3}, 0, sigma, 3);
    EXPECT_NEAR(stationary_mean(s, "energy"), 9 * (1 + 1 / 2.0 + 1 / 3.0) / 6, 1e-10);
    EXPECT_NEAR(stationary_mean(s, "exp(pi3)"), std::sinh(3) / 3, 1e-10);
  }
  const auto a = exponents(scene_of({1, 2, 3}, 0, half));
  EXPECT_EQ(*a.sum, 0);
  EXPECT_EQ(*a.dimension, 2);
  EXPECT_GT(a.value, 0.01);
}

}  // namespace
}  // namespace polhode::test
