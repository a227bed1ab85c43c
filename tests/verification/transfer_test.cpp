// SPDX-License-Identifier: Apache-2.0
// Operators of the schemes on the sphere: held to sampled paths, and to each other.
#include <gtest/gtest.h>

#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "experiments/weak/weak_sampled.hpp"
#include "run/run_experiment.hpp"
#include "scene/scene.hpp"
#include "sphere/expectations/expectation.hpp"
#include "support/verdicts.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

using test::scheme_of;

double transferred_energy(const subject& s, const scheme_entry& e, double dt, int steps, const transfer_rule& rule) {
  const auto op = make_transfer(s, e, dt, steps, rule);
  const Eigen::Vector3d start(s.scene.momentum.data());
  return op.law_after(start, steps).dot(op.basis.coefficients(*named_observable("energy", *s.sphere())));
}

// The fallback, where the operator can be asked too: |E f(X_dt) - E f(X)| of both.
TEST(Weak, CoupledLevelsFindWhatTheOperatorFinds) {
  const auto s = restricted(bind_scene(load_scene("paper")), {"lie_euler", "heun"});
  const auto expected = [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); };
  report::results out;
  report_sampled_orders({s, effort::quick, 2, 5}, s.schemes, {{"energy", *observable_of(s, "energy")}}, expected, out);
  int compared = 0;
  for (const auto& m : out.measurements) {
    if (m.quantity != "difference" || m.observable != "energy" || m.scheme != "lie_euler" || *m.dt() < 0.02) continue;
    const int steps = static_cast<int>(std::lround(asymptotic_levels(s, 64).horizon / *m.dt()));
    const auto& e = scheme_of(s, "lie_euler");
    const transfer_rule rule{{16, 1, 0}, {7, 2}};
    const double time = asymptotic_levels(s, 64).horizon, radius = s.sphere()->radius;
    const auto h = *named_observable("energy", *s.sphere());
    const Eigen::Vector3d start = radius * Eigen::Vector3d(s.scene.momentum.data()).normalized();
    const double exact = *expectation(*s.sphere(), h, start, time, 1e-10).value;
    EXPECT_NEAR(*m.value, std::fabs(transferred_energy(s, e, *m.dt(), steps, rule) - exact), 2 * (*m.high - *m.value))
        << *m.dt();  // four standard errors
    ++compared;
  }
  EXPECT_GE(compared, 4);
  ASSERT_EQ(out.verdicts.size(), 5u);  // order and limit of each, and the noise
  for (const auto& v : out.verdicts) EXPECT_NE(v.kind, report::verdict_kind::refuted) << v.scheme << ": " << v.reason;
}

TEST(Weak, CoupledLevelsDoNotDependOnTheCompany) {
  const auto s = restricted(bind_scene(load_scene("paper")), {"lie_euler", "magnus"});
  const auto found = [&](const std::vector<scheme_entry>& schemes) {
    const auto expected = [](const scheme_entry&) { return 1; };
    report::results out;
    report_sampled_orders({s, effort::quick, 2, 5}, schemes, {{"energy", *observable_of(s, "energy")}}, expected, out);
    std::vector<double> values;
    for (const auto& m : out.measurements)
      if (m.scheme == "lie_euler") values.push_back(m.value.value_or(NAN));
    return values;
  };
  const auto alone = found({scheme_of(s, "lie_euler")});  // magnus asks for areas, which lie_euler does not
  EXPECT_FALSE(alone.empty());
  EXPECT_EQ(alone, found(s.schemes));
}

/// Mean and standard error of the energy after `steps` steps of 64-path blocks.
std::pair<double, double> sampled_energy(const subject& s, const scheme_entry& e, double dt, int steps, int blocks) {
  const auto stepper = e.make(dt);
  increment_buffer noise(*s.model, steps, e.needs_areas);
  double sum = 0, square = 0;
  for (int b = 0; b < blocks; ++b) {
    auto states = replicated(s.scene.momentum);
    stepper->advance(states, noise.fill(11, static_cast<std::uint64_t>(b * block_lanes), 0, steps, dt));
    for (int lane = 0; lane < block_lanes; ++lane) {
      const double h = s.model->energy(lane_of(states, lane, 3));
      sum += h;
      square += h * h;
    }
  }
  const double n = static_cast<double>(blocks) * block_lanes, mean = sum / n;
  return {mean, std::sqrt((square / n - mean * mean) / n)};
}

// Schemes on the sphere, off it, and with areas; noise of any kind.
TEST(Transfer, IsWhatSampledPathsDo) {
  constexpr int steps = 8;
  constexpr double dt = 0.125;
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.3, 0.1, 0}, {-0.2, 0.4, 0.1}, {0, 0.3, 0.2}};
  const auto s = bind_scene(scene);
  for (const auto* name : {"lie_euler", "implicit_midpoint", "strang", "magnus", "heun", "milstein"}) {
    const auto& e = scheme_of(s, name);
    const bool sphere = e.info.casimir.exact;
    const auto rule = sphere ? transfer_rule{{12, 1, 0}, {5, 2}} : transfer_rule{{8, 5, 4}, {4, 2}};
    const auto [mean, error] = sampled_energy(s, e, dt, steps, 1000);
    EXPECT_LT(error, 5e-4);
    EXPECT_NEAR(transferred_energy(s, e, dt, steps, rule), mean, 4 * error) << name;
  }
}

TEST(Transfer, ThreeNodesAnAreaAreEnough) {
  const auto s = bind_scene(load_scene("paper"));
  const auto& e = scheme_of(s, "magnus");
  const double three = transferred_energy(s, e, 0.25, 8, {{10, 1, 0}, {5, 3}}),
               four = transferred_energy(s, e, 0.25, 8, {{10, 1, 0}, {5, 4}});
  EXPECT_NEAR(three, four, 1e-4 * 5.6e-4) << "of its weak error";
}

TEST(Transfer, KeepsConstantsAndTheUniformLawOfAFreeSplitting) {
  auto scene = load_scene("undamped");
  const auto s = bind_scene(scene);
  const auto op = make_transfer(s, scheme_of(s, "strang"), 0.25, 8, {{12, 1, 0}, {7, 3}});
  const auto law = op.stationary_law();
  EXPECT_LT(law.tail(law.size() - 1).norm(), 1e-8);
  EXPECT_NEAR(law.dot(op.basis.coefficients([](const Eigen::Vector3d&) { return 1.0; })), 1, 1e-13);
}

}  // namespace
}  // namespace polhode
