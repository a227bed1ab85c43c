// SPDX-License-Identifier: Apache-2.0
// Weak errors at all times: known in closed form, and a defect that the horizon does not show.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode {
namespace {

using test::quick_report;
using test::verdict_of;

constexpr double horizon = 8;

/// Noise alone, so long that errors have passed their maximum.
report::scene noise_alone() {
  auto scene = load_scene("paper");
  scene.vector("inertia") = {1, 1, 1};
  scene.number("theta") = 0;
  scene.horizon = horizon;
  scene.steps = {16, 32, 64, 128, 256};
  return scene;
}

/// Of a rotation by sigma sqrt(dt) g on harmonics of degree one, s = sigma^2 dt.
double degree_one_factor(double s) { return (1 + 2 * (1 - s) * std::exp(-s / 2)) / 3; }

TEST(WeakCourse, TheLargestErrorIsThatOfAllSteps) {
  const auto r = quick_report(restricted(bind_scene(noise_alone()), {"strang"}), weak_experiment().run);
  int compared = 0;
  for (const auto& m : r.measurements) {
    if (m.quantity != "largest error up to T" || m.observable != "pi1" || !m.dt()) continue;
    double largest = 0;
    const auto steps = std::lround(horizon / *m.dt());
    for (int n = 1; n <= steps; ++n)
      largest = std::max(
          largest, 0.6 * std::fabs(std::pow(degree_one_factor(0.25 * *m.dt()), n) - std::exp(-0.25 * *m.dt() * n)));
    EXPECT_GE(largest, *m.low - 1e-13) << *m.dt();
    EXPECT_LE(largest, *m.high + 1e-13) << *m.dt();
    EXPECT_LT(*m.high - *m.low, 1e-3 * largest) << *m.dt();
    const double at_end =
        0.6 * std::fabs(std::pow(degree_one_factor(0.25 * *m.dt()), steps) - std::exp(-0.25 * horizon));
    EXPECT_GT(largest, 1.2 * at_end);
    ++compared;
  }
  EXPECT_GE(compared, 5);
  EXPECT_EQ(verdict_of(r, "weak order, uniformly in time").kind, report::verdict_kind::holds)
      << verdict_of(r, "weak order, uniformly in time").reason;
}

/// The noise and a hand that turns the body once within the horizon: back where it should be at its end, at every dt.
struct once_round {
  static constexpr auto info = [] {
    auto out = strang::info;
    out.name = "once_round";
    return out;
  }();
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const double angle = 2 * std::numbers::pi / horizon * w.dt;
    const auto next = strang::step(system, mu, w);
    auto out = next;
    out[0] = S(std::cos(angle)) * next[0] - S(std::sin(angle)) * next[1];
    out[1] = S(std::sin(angle)) * next[0] + S(std::cos(angle)) * next[1];
    return out;
  }
};

TEST(WeakCourse, ADefectThatIsOverAtTheHorizonIsRefuted) {
  const auto r = quick_report(bind(noise_alone(), make_rigid_body, scheme_list<once_round>{}), weak_experiment().run);
  EXPECT_EQ(verdict_of(r, "weak order").kind, report::verdict_kind::holds) << verdict_of(r, "weak order").reason;
  const auto& v = verdict_of(r, "weak order, uniformly in time");
  EXPECT_EQ(v.kind, report::verdict_kind::refuted);
  EXPECT_EQ(v.reason.substr(0, 11), "wrong limit") << v.reason;
}

}  // namespace
}  // namespace polhode
