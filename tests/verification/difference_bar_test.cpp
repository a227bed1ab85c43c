// SPDX-License-Identifier: Apache-2.0
// How far a bias is known where no density is resolved (one noise vector): against higher degrees, against paths, and
// by what it refutes.
#include "experiments/laws/difference_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <polhode/integrate.hpp>
#include <polhode/schemes/lie_euler.hpp>
#include <polhode/systems/rigid_body.hpp>

#include "algebra/dense_algebra.hpp"
#include "experiments/laws/bias_reference.hpp"
#include "experiments/laws/stationary_bias.hpp"
#include "experiments/laws/true_law.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "statistics/sample.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"

namespace polhode {
namespace {

const report::scene single = load_scene("single");

/// The biases on one degree, and their bars, from the upper left corner of an operator.
struct known_biases {
  Eigen::VectorXd value, bar;
};
known_biases on_degree(const subject& s, const law_observables& all, const Eigen::MatrixXd& step, int degree) {
  const auto p = *s.sphere();
  const Eigen::MatrixXd functions = coefficients_of(all, p.radius, degree);
  const auto generator = project_generator(backward_operator(p, degree), functions);
  const Eigen::MatrixXd corner = step.topLeftCorner(functions.rows(), functions.rows());
  const Eigen::RowVectorXd law = invariant_law(corner, 1 / std::sqrt(4 * std::numbers::pi));
  return {((law - generator.law) * functions).transpose(), difference_bar(corner, law, generator, functions)};
}

class Biases : public testing::TestWithParam<const char*> {};

// Some eighty biases a scheme, from coarse degrees on, against the one of a degree so high that it is as good as exact
// for them. No sign and no accident of a last change: three times that is not enough in some.
TEST_P(Biases, LieWithinTheirBarsOfThoseOnAHigherDegree) {
  constexpr int finest = 36;
  const auto s = restricted(bind_scene(single), {GetParam()});
  const auto all = bias_observables(s);
  int by_last_change = 0, wide = 0, cases = 0;
  for (const double dt : {0.25, 0.03125}) {
    const auto op = make_transfer(s, s.schemes[0], dt, 1, {{finest, 1, 0}, {7, 2}});
    const auto exact = on_degree(s, all, op.matrix, finest);
    Eigen::VectorXd before = on_degree(s, all, op.matrix, 8).value;
    for (const int degree : {12, 16, 20, 24}) {
      const auto found = on_degree(s, all, op.matrix, degree);
      for (Eigen::Index k = 0; k < all.count(); ++k, ++cases) {
        const double off = std::fabs(found.value[k] - exact.value[k]);
        EXPECT_LE(off, found.bar[k]) << all.names[static_cast<std::size_t>(k)] << " at degree " << degree;
        EXPECT_LE(std::fabs(found.value[k] - before[k]), found.bar[k] * (1 + 1e-9));  // whatever the signs
        by_last_change += off > 3 * std::fabs(found.value[k] - before[k]);
        wide += found.bar[k] > 1000 * off;
      }
      before = found.value;
    }
  }
  EXPECT_GT(by_last_change, 0) << "a bar by the last change would have done in all of " << cases;
  EXPECT_LT(wide, cases / 5) << "bars say nothing";
}
INSTANTIATE_TEST_SUITE_P(OneNoiseVector, Biases, testing::Values("implicit_midpoint", "cayley_heun", "strang_weak2"));

/// Mean of h after so long a time that the start is forgotten, of independent paths.
template <class Scheme>
interval_estimate late_energy(double dt) {
  constexpr int paths = 20'000, steps = 120;
  const vec<double, 3> sigma[] = {{{0.3, 0.4, 0.5}}};
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::from_vectors(sigma));
  std::vector<double> energy;
  for (std::uint64_t path = 0; path < paths; ++path)
    energy.push_back(
        body.energy(integrate<Scheme>(body, vec<double, 3>{{0.6, 0.48, 0.64}}, dt, steps, {.seed = 1, .path = path})));
  return mean_interval(energy);
}

TEST(SampledBias, IsThatOfTheOperatorUnderOneNoiseVector) {
  constexpr double dt = 0.5;
  const auto s = restricted(bind_scene(single), {"lie_euler"});
  std::string reason;
  const auto reference = bias_by_difference(s, true_law(s), reason);
  ASSERT_TRUE(reference) << reason;
  const auto bias = reference->of(s, s.schemes[0], dt, 4);
  const auto truth = stationary_mean(*s.sphere(), *named_observable("energy", *s.sphere()), 1e-6);
  const auto sampled = late_energy<lie_euler>(dt);
  EXPECT_LT(bias.uncertainty[0], 0.02 * std::fabs(bias.error[0]));
  EXPECT_NEAR(sampled.value, *truth.value + bias.error[0], 2 * half_width(sampled) + bias.uncertainty[0]);
  EXPECT_GT(std::fabs(bias.error[0]), 4 * half_width(sampled)) << "the sample does not tell a bias from none";
}

/// The scheme as it ships, with the steps of another scene.
report::verdict verdict_on(const char* scheme, double noise, double dissipation) {
  auto scene = single;
  scene.steps = {16, 32, 64, 128, 256};
  auto stepped = scene;
  for (auto& v : stepped.vectors("sigma"))
    for (double& x : v) x *= noise;
  stepped.number("theta") *= dissipation;
  auto s = restricted(bind_scene(scene), {scheme});
  s.schemes = restricted(bind_scene(stepped), {scheme}).schemes;
  return test::quick_report(s, report_stationary_bias).verdicts.at(0);
}

TEST(OneNoiseVector, NoiseOffByAFifthOfAPerCentIsRefutedByTheStationaryLawAndTheHealthySchemeIsNot) {
  const auto v = verdict_on("lie_trotter", 1.002, 1);
  EXPECT_EQ(v.kind, report::verdict_kind::refuted) << v.reason;
  EXPECT_EQ(v.reason.substr(0, 11), "wrong limit") << v.reason;
  const auto healthy = verdict_on("lie_trotter", 1, 1);
  EXPECT_EQ(healthy.kind, report::verdict_kind::holds) << healthy.reason;
}

}  // namespace
}  // namespace polhode
