// SPDX-License-Identifier: Apache-2.0
// Constants of a scheme's modified equation and the variance of its averages: known answers, and drivers and clocks
// that have to be refuted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/modified/ergodic_variance.hpp"
#include "experiments/modified/leading_constants.hpp"
#include "experiments/modified/modified_constants.hpp"
#include "experiments/modified/modified_table.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

using test::quick_results, test::scheme_of, test::verdict_of;

/// The constants of a driver that takes `off` steps too many, over a share of the horizon.
report::verdict constants_of(std::string_view name, std::int64_t off, double share) {
  const auto s = bind_scene(load_scene("paper"));
  const auto scheme = scheme_of(s, name);
  const auto averages = averages_on(s);
  const int order = static_cast<int>(scheme.info.weak_order.isotropic);
  error_table t{std::string(name), {}, {}, {}};
  const auto grid = modified_levels(s);
  for (const int steps : grid.steps) {
    const double dt = grid.horizon / steps;
    const auto op = make_transfer(s, scheme, share * dt, 1, {{16, 1, 0}, {7, 2}});
    const Eigen::VectorXd found = averages.of(op, Eigen::Vector3d(s.scene.momentum.data()), steps + off);
    t.add(dt, {found - averages.value(),
               averages.uncertainty() + (1e-12 + 1e-8 * std::pow(dt, order)) * averages.size(), true});
  }
  const double rate = fastest_rate(s);
  const std::vector<double> dt{1 / (16 * rate), 1 / (32 * rate), 1 / (64 * rate), 1 / (128 * rate)};
  const expansion_frame coarse(s, averages, 12, dt), fine(s, averages, 16, dt);
  const auto predicted = predicted_constants(s, scheme, averages, coarse, fine, order);
  return judge_constants(leading_constants(averages.at_horizon, t, 0, predicted, order), order, rate);
}

TEST(LeadingConstants, DriversThatMiscountAreRefuted) {
  for (const auto* scheme : {"lie_euler", "strang_weak2"}) {
    const auto healthy = constants_of(scheme, 0, 1);
    EXPECT_EQ(healthy.kind, report::verdict_kind::holds) << scheme << ": " << healthy.reason;
    EXPECT_NEAR(*healthy.estimate, *healthy.expected, 1e-5 * std::fabs(*healthy.expected));
    for (const std::int64_t off : {-1, 1})
      EXPECT_EQ(constants_of(scheme, off, 1).kind, report::verdict_kind::refuted) << scheme << ' ' << off;
    EXPECT_EQ(constants_of(scheme, 0, 0.99).kind, report::verdict_kind::refuted) << scheme;
  }
}

/// Strong noise about one axis: by all levels the error of Pi_1 does not vanish with dt, by a sixth of its certainty.
TEST(LeadingConstants, WhatOneRuleOfTwoFindsIsNoRefutation) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {3.2258025755885602, 0.65497060247249972, 0.78447667770932794};
  scene.number("theta") = 0.31399547462472188;
  scene.momentum = {0.61723509863248949, 0.47148945507866363, 0.066032148277920241};
  scene.vectors("sigma") = {{-1.8052490067401659, 0, 0}, {0, 0.41100541459169243, 0}, {0, 0, 0.48681560896093712}};
  const auto r = quick_results(restricted(bind_scene(scene), {"strang_weak2"}), {"modified"});
  EXPECT_TRUE(std::ranges::any_of(
      r.verdicts, [](const report::verdict& v) { return v.claim.starts_with("leading constant") && v.estimate; }));
  for (const auto& v : r.verdicts) EXPECT_NE(v.kind, report::verdict_kind::refuted) << v.claim << ": " << v.reason;
}

// A spherical body under isotropic noise: one exponential of the Gaussian vector has log(T)/dt = sigma^2 L^2/2 + dt
// sigma^4 L^2/24 + … on every degree (docs/model.md, section 2), and L^2 = -2 on the first: the rate of Pi_1 is off by
// -sigma^4 dt/12.
TEST(LeadingConstants, OfASphericalBodyAreKnown) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  const auto s = bind_scene(scene);
  const auto averages = averages_on(s);
  const double rate = fastest_rate(s), sigma2 = 0.25;
  const std::vector<double> dt{1 / (16 * rate), 1 / (32 * rate), 1 / (64 * rate), 1 / (128 * rate)};
  const expansion_frame coarse(s, averages, 8, dt), fine(s, averages, 12, dt);
  const auto found = predicted_constants(s, scheme_of(s, "lie_euler"), averages, coarse, fine, 1);
  const auto pi1 =
      static_cast<std::size_t>(std::ranges::find(averages.at_horizon.names, "pi1") - averages.at_horizon.names.begin());
  const double exact = -2 * sigma2 * sigma2 / 12 * std::exp(-2 * sigma2) * 0.6;  // T = 2
  EXPECT_NEAR(found[pi1].value, exact, 1e-6 * std::fabs(exact)) << found[pi1].low << ' ' << found[pi1].high;
}

// Isotropic noise alone: degree one is one eigenspace, of the equation with -sigma^2 and of a rotation by sigma
// sqrt(dt) g with (1 + 2 E cos)/3, E cos |sigma sqrt(dt) g| = (1 - s) exp(-s/2), s = sigma^2 dt;
// of a spherical body strang does nothing else.
TEST(ErgodicVariance, OfASphericalBodyIsKnown) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  const auto s = bind_scene(scene);
  const double sigma2 = 0.25, dt = 0.125, share = sigma2 * dt;
  exact_averages one{{"pi1"}, {*named_observable("pi1", *s.sphere())}, {}, {}, {}};
  one.value = one.uncertainty = one.size = Eigen::VectorXd::Ones(1);
  law_averages averages;
  averages.stationary = one;
  EXPECT_NEAR(ergodic_variances(s, averages).value[0], 2.0 / 3 / sigma2, 1e-12);
  const auto op = make_transfer(s, scheme_of(s, "strang"), dt, 1, {{12, 1, 0}, {9, 2}});
  const double factor = (1 + 2 * (1 - share) * std::exp(-share / 2)) / 3;
  EXPECT_NEAR(ergodic_variances(one, op, sum_of_powers(op), dt)[0], dt / 3 * (1 + factor) / (1 - factor), 1e-10);
}

// A clock that is one per cent slow leaves the stationary law alone, and not the variance.
TEST(ErgodicVariance, ASlowClockIsRefuted) {
  auto s = bind_scene(load_scene("paper"));
  auto scheme = scheme_of(s, "lie_heun");
  auto scene = s.scene;
  for (auto& v : scene.vectors("sigma"))
    for (auto& x : v) x *= std::sqrt(0.99);
  for (auto& x : scene.vector("inertia")) x /= 0.99;
  const auto slow = bind_scene(scene);  // theta k by 0.99, too: the same law
  s.schemes = {scheme_of(slow, "lie_heun")};
  const auto r = quick_results(s, {"modified"});
  EXPECT_EQ(verdict_of(r, "asymptotic variance converges").kind, report::verdict_kind::refuted);
  s.schemes = {scheme};
  EXPECT_EQ(verdict_of(quick_results(s, {"modified"}), "asymptotic variance converges").kind,
            report::verdict_kind::holds);
}

}  // namespace
}  // namespace polhode
