// Weak errors and stationary bias without sampling: held to known answers and to sampled paths.
#include <gtest/gtest.h>

#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/weak/weak_sampled.hpp"
#include "reports/writers/json.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
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

report::results quick(const std::vector<std::string>& schemes, const std::string& experiment, int threads = 2) {
  verify_options options;
  options.schemes = schemes;
  options.experiments = {experiment};
  options.effort = effort::quick;
  options.threads = threads;
  return verify(load_scene("paper"), options);
}

double value_at(const report::results& r, std::string_view scheme, std::string_view quantity,
                std::string_view observable, int steps) {
  for (const auto& m : r.measurements)
    if (m.scheme == scheme && m.quantity == quantity && m.observable == observable && m.method == "transfer" &&
        std::fabs(*m.dt() - 2.0 / steps) < 1e-12)
      return *m.value;
  return std::nan("");
}

struct known {
  const char *scheme, *quantity, *observable;
  std::vector<double> values;  // n = 4, 8, 16, 32
  double relative;             // of the printed digits
};

void expect_known(const report::results& r, const known& k) {
  int steps = 4;
  for (const double value : k.values) {
    EXPECT_NEAR(value_at(r, k.scheme, k.quantity, k.observable, steps), value, k.relative * value)
        << k.scheme << ' ' << k.observable << ' ' << steps;
    steps *= 2;
  }
}

// Written apart from this project: numpy, scalar steps, dense exponential. strang_weak2 at n = 4 with nine Hermite
// nodes; seven leave 2e-7.
TEST(Weak, ErrorsAreTheKnownOnes) {
  const auto r = quick({"lie_euler", "implicit_midpoint", "strang_two_turns", "strang_weak2"}, "weak");
  expect_known(r, {"lie_euler", "error", "energy", {8.429e-3, 4.329e-3, 2.186e-3, 1.098e-3}, 1e-3});
  expect_known(r, {"implicit_midpoint", "error", "energy", {4.82e-4, 2.79e-4, 1.51e-4, 7.90e-5}, 4e-3});
  expect_known(r, {"strang_two_turns", "error", "energy", {3.0972e-4, 7.7668e-5, 1.9430e-5, 4.8580e-6}, 1e-4});
  expect_known(r, {"strang_two_turns", "error", "pi3", {4.4170e-4, 1.0529e-4, 2.5985e-5, 6.4751e-6}, 2e-4});
  expect_known(r, {"strang_weak2", "error", "energy", {4.0813e-4, 1.022e-4, 2.556e-5, 6.389e-6}, 3e-4});
  expect_known(r, {"strang_weak2", "error", "pi3", {9.2392e-4, 2.3347e-4}, 1e-4});
  expect_known(r, {"strang_extrapolated", "error", "pi1", {4.4446e-6, 2.7219e-7, 1.6620e-8, 1.0008e-9}, 4e-3});
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
  EXPECT_EQ(r.verdicts.size(), 9u);  // four schemes at the horizon and at all times, one combination
}

// dt^2, dt^3 and dt^4 gone: between n = 4, 8, 16 errors fall by more than 2^5, then rounding is reached.
TEST(Weak, FourRunsTogetherFallFasterThanTheFifthPower) {
  const auto r = quick({"strang_two_turns"}, "weak");
  for (const char* observable : {"energy", "pi2", "pi1^2", "pi2^2", "pi3^2", "exp(pi3)"}) {
    const auto at = [&](int steps) { return value_at(r, "strang_extrapolated5", "error", observable, steps); };
    EXPECT_GT(at(4), 32 * at(8)) << observable;
    EXPECT_GT(at(8), 32 * at(16)) << observable;
    EXPECT_LT(at(16), 2e-12) << observable;
  }
  const auto steps = [&](std::string_view scheme, std::string_view accuracy) {
    for (const auto& m : r.measurements)
      if (m.scheme == scheme && m.quantity == "steps for an error" && m.observable == accuracy) return *m.value;
    return std::nan("");
  };
  EXPECT_GT(steps("strang_two_turns", "1e-08"), 20 * steps("strang_extrapolated", "1e-08"));
  EXPECT_GT(steps("strang_extrapolated", "1e-08"), steps("strang_extrapolated5", "1e-08"));
}

// The fallback, where the operator can be asked too: |E f(X_dt) - E f(X)| of both.
TEST(Weak, CoupledLevelsFindWhatTheOperatorFinds) {
  const auto s = restricted(bind_scene(load_scene("paper")), {"lie_euler", "heun"});
  const order_question q{"weak",
                         "weak order",
                         {{"difference", "energy", 1}},
                         [&](const scheme_entry& e) { return weak_order_on(e.info, s.model->noise()); },
                         {}};
  report::results out;
  report_sampled_orders({s, effort::quick, 2, 5}, s.schemes, q, {*named_observable("energy", *s.sphere())}, out);
  int compared = 0;
  for (const auto& m : out.measurements) {
    if (m.quantity != "difference" || m.scheme != "lie_euler" || *m.dt() < 0.02) continue;
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
    const order_question q{
        "weak", "weak order", {{"difference", "energy", 1}}, [](const scheme_entry&) { return 1; }, {}};
    report::results out;
    report_sampled_orders({s, effort::quick, 2, 5}, schemes, q, {*named_observable("energy", *s.sphere())}, out);
    std::vector<double> values;
    for (const auto& m : out.measurements)
      if (m.scheme == "lie_euler") values.push_back(m.value.value_or(NAN));
    return values;
  };
  const auto alone = found({scheme_of(s, "lie_euler")});  // magnus asks for areas, which lie_euler does not
  EXPECT_FALSE(alone.empty());
  EXPECT_EQ(alone, found(s.schemes));
}

TEST(Gibbs, BiasIsTheKnownOne) {
  const auto r = quick({"lie_euler", "implicit_midpoint", "strang_two_turns", "strang_weak2"}, "gibbs");
  expect_known(r, {"lie_euler", "bias", "energy", {1.059e-2, 5.411e-3, 2.728e-3, 1.369e-3}, 1e-3});
  expect_known(r, {"implicit_midpoint", "bias", "energy", {1.25e-3, 7.01e-4, 3.73e-4, 1.93e-4}, 4e-3});
  expect_known(r, {"strang_two_turns", "bias", "energy", {3.2265e-4, 8.0616e-5, 2.0149e-5, 5.0368e-6}, 1e-4});
  expect_known(r, {"strang_weak2", "bias", "energy", {3.215e-4, 8.038e-5, 2.009e-5, 5.023e-6}, 2.5e-4});
  int orders = 0;
  for (const auto& v : r.verdicts) orders += v.claim == "order of the stationary bias" && *v.estimate > 0.9;
  EXPECT_EQ(orders, 4);
}

TEST(Transfer, ThreadsChangeNothing) {
  const auto text = [](int threads) {
    auto r = quick({"lie_euler", "heun"}, "weak", threads);
    r.provenance = {};
    return report::to_json(r);
  };
  EXPECT_EQ(text(1), text(3));
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
