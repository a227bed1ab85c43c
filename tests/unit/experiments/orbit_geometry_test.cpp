// SPDX-License-Identifier: Apache-2.0
// Orbits off the sphere: tangent spaces, volumes, divergences in closed form, and starts all over them.
#include "experiments/lyapunov/orbit_geometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "ensemble/coadjoint_matrices.hpp"
#include "ensemble/noise/paths.hpp"
#include "ensemble/orbit_start.hpp"
#include "experiments/lyapunov/orbit_verdicts.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

using vector3 = Eigen::Vector3d;

subject scene_of(const char* name) { return bind_scene(load_scene(name)); }

Eigen::VectorXd state_of(std::initializer_list<double> mu) {
  return Eigen::Map<const Eigen::VectorXd>(mu.begin(), static_cast<Eigen::Index>(mu.size()));
}

double quadratic(const vector3& x, const vector3& diagonal) { return x.dot(diagonal.cwiseProduct(x)); }

TEST(OrbitGeometry, CasimirsAreNormalToTheTangentSpaceOfTheTop) {
  const auto s = scene_of("heavy_top");
  const orbit_geometry orbit(*s.model, s.scene.momentum);
  ASSERT_EQ(orbit.dimension(), 4);
  const auto mu = state_of({0.3, -0.9, 0.4, 0.6, 0.0, 0.8});
  const auto basis = orbit.tangents(mu);
  EXPECT_LT((basis.transpose() * basis - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-14);
  Eigen::VectorXd length = Eigen::VectorXd::Zero(6), product(6);  // gradients of |Gamma|^2 / 2 and of Pi.Gamma
  length.tail(3) = mu.tail(3);
  product << mu.tail(3), mu.head(3);
  EXPECT_LT((basis.transpose() * length).norm(), 1e-14);
  EXPECT_LT((basis.transpose() * product).norm(), 1e-14);
}

double divergence_at(const orbit_geometry& orbit, const Eigen::VectorXd& mu) {
  const auto each = orbit.divergences(replicated({mu.data(), static_cast<std::size_t>(mu.size())}));
  EXPECT_TRUE((each.array() == each[0]).all());
  return each[0];
}

// docs/model.md, section 1: the divergence is -theta sum_i V_i^2 h, V_i f = ad*_{e_i} mu.grad f.
TEST(OrbitGeometry, DivergenceOfTheTopIsItsClosedForm) {
  const auto s = scene_of("heavy_top");
  const orbit_geometry orbit(*s.model, s.scene.momentum);
  const vector3 inverse = vector3(1.0, 1.5, 2.2).cwiseInverse(), pull = 0.8 * vector3(0.3, -0.4, 0.6);
  for (const auto& mu : {state_of({0.5, -0.3, 0.7, 0.48, 0.6, 0.64}), state_of({-2, 3, 1, 0, -0.6, 0.8})}) {
    const vector3 pi = mu.head(3), gamma = mu.tail(3);
    const double exact = -0.3 * (inverse.sum() * (pi.squaredNorm() + gamma.squaredNorm()) - 3 * quadratic(pi, inverse) -
                                 quadratic(gamma, inverse) - 2 * pull.dot(gamma));
    EXPECT_NEAR(divergence_at(orbit, mu), exact, 1e-11 * std::fabs(exact) + 1e-11);
  }
}

// Two bodies: each has -theta (c^2 tr I^-1 - 3 Pi.I^-1 Pi), and the coupling k Pi_1.Pi_2 adds 4 theta k Pi_1.Pi_2. The
// volume is the area over |Pi| of each.
TEST(OrbitGeometry, DivergenceAndVolumeOfTwoBodiesAreTheirClosedForms) {
  const auto s = scene_of("so4");
  const orbit_geometry orbit(*s.model, s.scene.momentum);
  ASSERT_EQ(orbit.dimension(), 4);
  const auto mu = state_of({0.6, -0.2, 0.9, -0.5, 0.1, 1.3});
  const vector3 one = mu.head(3), two = mu.tail(3);
  const vector3 first = vector3(1, 2, 3).cwiseInverse(), second = vector3(1.25, 2.5, 1.6).cwiseInverse();
  const double exact = -0.4 * (first.sum() * one.squaredNorm() - 3 * quadratic(one, first) +
                               second.sum() * two.squaredNorm() - 3 * quadratic(two, second) - 4 * 0.3 * one.dot(two));
  EXPECT_NEAR(divergence_at(orbit, mu), exact, 1e-11);
  EXPECT_NEAR(orbit.log_density(mu), -std::log(one.norm() * two.norm()), 1e-13);
}

TEST(KeptVector, IsTheVerticalOfATopAndTheFirstOfManySpins) {
  EXPECT_EQ(kept_vector(*scene_of("heavy_top").model), 3);
  EXPECT_EQ(kept_vector(*scene_of("spin_ring").model), 0);
  EXPECT_EQ(kept_vector(*scene_of("so4").model), 0);
  EXPECT_EQ(kept_vector(*scene_of("maxwell_bloch").model), std::nullopt);
  EXPECT_TRUE(keeps_length(*scene_of("so4").model));
  EXPECT_FALSE(keeps_length(*scene_of("heavy_top").model));
}

TEST(OrbitStart, KeepsTheCasimirs) {
  for (const char* name : {"heavy_top", "spin_ring", "maxwell_bloch"}) {
    const auto s = scene_of(name);
    const auto states = orbit_start(*s.model, s.scene.momentum).block(1, 0);
    const auto expected = s.model->casimirs(s.scene.momentum), sizes = s.model->casimir_sizes(s.scene.momentum);
    for (int lane = 0; lane < block_lanes; ++lane) {
      const auto found = s.model->casimirs(lane_of(states, lane, s.model->dimension()));
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-13 * sizes[i]) << name;
    }
  }
}

// On a sphere of radius c: E[mu_i] = 0, E[mu_i mu_j] = c^2/3 delta_ij, of both bodies, and E[mu_i mu_j] = 0 between
// them.
TEST(OrbitStart, IsUniformOnEachOfTwoSpheres) {
  const auto s = scene_of("so4");
  const orbit_start start(*s.model, s.scene.momentum);
  constexpr int blocks = 64;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(6);
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(6, 6);
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const auto states = start.block(3, block * block_lanes);
    const Eigen::Map<const Eigen::MatrixXd> all(states.data(), block_lanes, 6);
    mean += all.colwise().sum().transpose() / (blocks * block_lanes);
    square += all.transpose() * all / (blocks * block_lanes);
  }
  Eigen::VectorXd variance(6);
  variance << vector3::Constant(1.0 / 3), vector3::Constant(0.98 / 3);
  const double error = 1 / std::sqrt(3.0 * blocks * block_lanes);
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 4 * error);
  EXPECT_LT((square - Eigen::MatrixXd(variance.asDiagonal())).cwiseAbs().maxCoeff(), 4 * error);
}

// Columns whose means are 0 within a wide interval, 0.3 within a narrow one, and 0.
TEST(JudgeAll, TellsTheWorst) {
  Eigen::MatrixXd values(4, 3);
  values << -2, 0.29, 0.01, 2, 0.31, -0.01, -2, 0.31, -0.01, 2, 0.29, 0.01;
  const auto judged = [&](std::initializer_list<int> columns) {
    return judge_all(values(Eigen::all, std::vector<int>(columns)), 0.1,
                     [](Eigen::Index k) { return "number " + std::to_string(k); });
  };
  using enum report::verdict_kind;
  EXPECT_EQ(judged({2}).kind, holds);
  EXPECT_EQ(judged({2, 0}).kind, inconclusive);
  EXPECT_EQ(judged({0, 1, 2}).kind, refuted);
  EXPECT_EQ(judged({0, 1, 2}).reason.find("number 1"), 0u);
  const auto one = mean_of(values.col(1));
  EXPECT_GT(*judged({1, 2}).high - *judged({1, 2}).low, one.high - one.low) << "two at once";
}

TEST(JudgeSign, NeedsAnIntervalOnOneSide) {
  using enum report::verdict_kind;
  const interval_estimate above{0.2, 0.1, 0.3}, below{-0.2, -0.3, -0.1}, about{0.05, -0.1, 0.2};
  EXPECT_EQ(judge_sign(above).kind, holds);
  EXPECT_EQ(judge_sign(about).kind, inconclusive);
  EXPECT_EQ(judge_sign(below, below).kind, holds);
  EXPECT_EQ(judge_sign(above, below).kind, refuted);
  EXPECT_EQ(judge_sign(about, below).kind, inconclusive);
}

TEST(KaplanYorke, IsThatOfTheSpectrum) {
  EXPECT_EQ(kaplan_yorke(std::vector{-0.1, -0.2}), 0);
  EXPECT_DOUBLE_EQ(kaplan_yorke(std::vector{0.02, -0.1}), 1.2);
  EXPECT_DOUBLE_EQ(kaplan_yorke(std::vector{0.3, -0.1, -0.4, -0.5}), 2.5);
  EXPECT_EQ(kaplan_yorke(std::vector{0.2, 0.1, -0.1, -0.2}), 4);
}

}  // namespace
}  // namespace polhode
