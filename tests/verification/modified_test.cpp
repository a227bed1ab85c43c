// SPDX-License-Identifier: Apache-2.0
// Which equation a scheme solves: known answers, and healthy schemes.
#include <gtest/gtest.h>

#include <cmath>

#include "algebra/logarithm_action.hpp"
#include "experiments/modified/modified_constants.hpp"
#include "experiments/modified/modified_table.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "support/dense.hpp"
#include "support/verdicts.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

using test::scheme_of;

nearest_body effective(std::string_view scheme, double dt) {
  const auto s = bind_scene(load_scene("paper"));
  const auto op = make_transfer(s, scheme_of(s, scheme), dt, 1, {{12, 1, 0}, {8, 2}});
  return generator_family(s.sphere()->radius).nearest(*generator_of_step(op.matrix, dt));
}

struct known_parameters {
  const char* scheme;
  double dt;
  Eigen::Vector3d k, theta_k, q;
  double residual, digits;  // of the residual
};

// Written apart from this project (numpy, dense logarithm), to four decimals; docs/model.md, section 10.
TEST(Modified, EffectiveParametersAreTheKnownOnes) {
  for (const auto& a : {known_parameters{"lie_euler",
                                         0.1,
                                         {0.4054, -0.1152, -0.2902},
                                         {0.1930, -0.0580, -0.1351},
                                         {0.2526, 0.2498, 0.2491},
                                         1.67e-2,
                                         1e-4},
                        known_parameters{"lie_euler",
                                         0.05,
                                         {0.3971, -0.1131, -0.2840},
                                         {0.1938, -0.0567, -0.1370},
                                         {0.2513, 0.2500, 0.2496},
                                         8.3e-3,
                                         1e-4},
                        known_parameters{"strang_weak2",
                                         0.1,
                                         {0.3890, -0.1111, -0.2779},
                                         {0.1947, -0.0556, -0.1391},
                                         {0.2500, 0.2500, 0.2499},
                                         2.7e-4,
                                         1e-5}}) {
    const auto body = effective(a.scheme, a.dt);
    EXPECT_LT((body.parameters.quadratic - a.k).cwiseAbs().maxCoeff(), 6e-5) << a.scheme << ' ' << a.dt;
    EXPECT_LT((body.parameters.dissipation - a.theta_k).cwiseAbs().maxCoeff(), 6e-5) << a.scheme << ' ' << a.dt;
    EXPECT_LT((body.parameters.noise.diagonal() - a.q).cwiseAbs().maxCoeff(), 6e-5) << a.scheme << ' ' << a.dt;
    EXPECT_NEAR(body.residual, a.residual, a.digits) << a.scheme << ' ' << a.dt;
  }
}

sphere_problem general_problem() {
  auto p = body_on_sphere({0.7, 1.9, 2.6}, 0.3, 1.4, Eigen::Matrix3d::Zero());
  p.covariance << 0.5, 0.1, -0.05, 0.1, 0.3, 0.08, -0.05, 0.08, 0.4;
  return p;
}

TEST(Modified, TheFamilyHoldsItsOwnGenerators) {
  const auto p = general_problem();
  const Eigen::MatrixXd generator = backward_operator(p, 8);
  const auto body = generator_family(p.radius).nearest(generator.middleCols(1, 8));
  const auto exact = parameters_of(p);
  EXPECT_LT((body.parameters.quadratic - exact.quadratic).norm(), 1e-13);
  EXPECT_LT((body.parameters.dissipation - exact.dissipation).norm(), 1e-13);
  EXPECT_LT((body.parameters.noise - exact.noise).norm(), 1e-13);
  EXPECT_LT(body.residual, 1e-14);
}

// Eigenvalues of the whole lie far within those of a principal logarithm.
TEST(Modified, LogarithmUndoesTheExponential) {
  const Eigen::MatrixXd generator = backward_operator(general_problem(), 6);
  const Eigen::MatrixXd whole = 0.05 * generator, step = test::exponential_of(whole);
  const auto columns = logarithm_action(step, Eigen::MatrixXd::Identity(step.rows(), 9));
  ASSERT_TRUE(columns);
  EXPECT_LT((*columns - whole.leftCols(9)).norm(), 1e-11 * whole.norm());
  const Eigen::MatrixXd reflection = -Eigen::MatrixXd::Identity(4, 4);
  EXPECT_FALSE(logarithm_action(reflection, Eigen::MatrixXd::Identity(4, 4)));
  EXPECT_FALSE(logarithm_action(Eigen::MatrixXd::Constant(4, 4, NAN), Eigen::MatrixXd::Identity(4, 4)));
}

// Weak noise along two axes: the averages need degrees beyond what quick affords.
TEST(Modified, AveragesOfHighDegreeAreNotTriedAndSayAtWhichEffortTheyAre) {
  auto s = bind_scene(load_scene("anisotropic"));
  law_averages averages;
  averages.at_horizon = {{"pi1"},
                         {*named_observable("pi1", *s.sphere())},
                         Eigen::VectorXd::Ones(1),
                         Eigen::VectorXd::Zero(1),
                         Eigen::VectorXd::Ones(1),
                         32};
  averages.stationary = averages.at_horizon;
  const auto said = [&](effort e, int degree) {
    auto kept = averages;
    kept.at_horizon.degree = kept.stationary.degree = degree;
    report::results out;
    keep_affordable({s, e, 1}, {scheme_of(s, "strang")}, kept, out);
    EXPECT_EQ(kept.at_horizon.count() == 0, out.verdicts.size() == 3) << degree;
    return out.verdicts.empty() ? report::verdict_kind::holds : out.verdicts[0].kind;
  };
  EXPECT_EQ(said(effort::quick, 24), report::verdict_kind::holds);
  EXPECT_EQ(said(effort::quick, 32), report::verdict_kind::not_tried);
  EXPECT_EQ(said(effort::standard, 32), report::verdict_kind::holds);
  EXPECT_EQ(said(effort::quick, 128), report::verdict_kind::inconclusive);
}

TEST(Modified, HealthySchemesHoldAndThoseOffTheSphereAreSkipped) {
  const auto r = test::quick_results(bind_scene(load_scene("paper")), {"modified"});
  int holding = 0, skipped = 0;
  for (const auto& v : r.verdicts) {
    holding += v.kind == report::verdict_kind::holds;
    skipped += v.kind == report::verdict_kind::skipped;
  }
  EXPECT_EQ(holding, 17 + 6 * 13);
  EXPECT_EQ(skipped, 4);
  EXPECT_EQ(r.verdicts.size(), 17u + 6 * 13 + 4);
}

}  // namespace
}  // namespace polhode
