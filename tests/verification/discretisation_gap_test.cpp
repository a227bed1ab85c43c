// SPDX-License-Identifier: Apache-2.0
// The spectral gap of each scheme: known answers, another method, and defects.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "experiments/modified/discretisation_gap.hpp"
#include "experiments/modified/ergodic_variance.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

constexpr std::string_view claim = "spectral gap converges";

report::results modified_of(const subject& s) { return test::quick_report(s, modified_experiment().run); }

const report::verdict& gap_verdict(const report::results& r) { return test::verdict_of(r, claim); }

subject louder(const report::scene& scene, double noise, const std::string& scheme) {
  auto changed = scene;
  for (auto& v : changed.vectors("sigma"))
    for (double& x : v) x *= noise;
  auto s = restricted(bind_scene(scene), {scheme});
  s.schemes = restricted(bind_scene(changed), {scheme}).schemes;
  return s;
}

// Isotropic noise alone relaxes harmonics of degree l at sigma^2 l(l + 1)/2; a rotation by sigma sqrt(dt) g takes those
// of degree one to (1 + 2 (1 - s) exp(-s/2))/3, s = sigma^2 dt.
TEST(DiscretisationGap, OfNoiseAloneIsKnown) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  const auto s = restricted(bind_scene(scene), {"strang"});
  EXPECT_NEAR(true_gap(s).gap.value[0], 0.25, 1e-12);
  for (const double dt : {0.5, 0.125}) {
    const auto op = make_transfer(s, s.schemes[0], dt, 1, {{8, 1, 0}, {11, 2}});
    const double share = 0.25 * dt, factor = (1 + 2 * (1 - share) * std::exp(-share / 2)) / 3;
    EXPECT_NEAR(discretisation_gap(sum_of_powers(op), dt, {}, 0), -std::log(factor) / dt, 1e-11) << dt;
  }
}

TEST(DiscretisationGap, IsThatOfAllEigenvalues) {
  for (const char* name : {"paper", "undamped", "anisotropic"}) {
    const auto s = restricted(bind_scene(load_scene(name)), {"lie_heun"});
    const double dt = 0.05;
    const auto op = make_transfer(s, s.schemes[0], dt, 1, {{8, 1, 0}, {5, 2}});
    const auto n = op.matrix.rows() - 1;
    const double whole = -std::log(eigenvalues_of(op.matrix.bottomRightCorner(n, n)).cwiseAbs().maxCoeff()) / dt;
    EXPECT_NEAR(discretisation_gap(sum_of_powers(op), dt, {}, 0), whole, 1e-9 * whole) << name;
  }
}

// The first mode is followed, its own error over dt below what is allowed for, and a spurious slower one is told.
TEST(DiscretisationGap, TheEquationsModeIsFollowed) {
  const double dt = 0.1;
  const Eigen::Vector3d rates(1, 0.95, 3), powers = (1 - (-dt * rates.array()).exp()).inverse();
  const Eigen::MatrixXd forgetting = powers.asDiagonal();
  const Eigen::VectorXcd mode = Eigen::VectorXcd::Unit(3, 0);
  EXPECT_NEAR(discretisation_gap(forgetting, dt, mode, 0.1), 1, 1e-12);
  EXPECT_NEAR(discretisation_gap(forgetting, dt, mode, 0.04), 0.95, 1e-12);
  EXPECT_NEAR(discretisation_gap(forgetting, dt, {}, 0.1), 0.95, 1e-12);
}

// The healthy twins: Modified.HealthySchemesHoldAndThoseOffTheSphereAreSkipped.
TEST(DiscretisationGap, ADefectOfTheNoiseAndAnOverclaimAreRefuted) {
  const auto scene = load_scene("paper");
  const auto spoilt = gap_verdict(modified_of(louder(scene, 1.001, "strang_weak2")));
  EXPECT_EQ(spoilt.kind, report::verdict_kind::refuted) << spoilt.reason;
  auto over = restricted(bind_scene(scene), {"strang"});
  over.schemes[0].info.weak_order = {.one_vector = 2, .isotropic = 2, .general = 2};
  const auto claimed = gap_verdict(modified_of(over));
  EXPECT_EQ(claimed.kind, report::verdict_kind::refuted) << claimed.reason;
}

TEST(DiscretisationGap, WhereThereIsNoneItIsSkipped) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  scene.vectors("sigma") = {{0.5, 0, 0}};
  const auto gap = true_gap(bind_scene(scene));
  EXPECT_EQ(gap.gap.count(), 0);
  EXPECT_FALSE(gap.undecided);
  EXPECT_FALSE(gap.reason.empty());
}

}  // namespace
}  // namespace polhode
