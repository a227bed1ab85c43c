// SPDX-License-Identifier: Apache-2.0
// Every mean under the stationary law is judged, not that of the energy alone.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/laws/stationary_bias.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode {
namespace {

using test::quick_report;

/// Lie-Euler, turned about axis 2 at a rate of 0.001: by symmetry that moves no mean of an even function of each
/// component at first order, h and its square among them.
struct slowly_turned {
  static constexpr auto info = [] {
    auto out = lie_euler::info;
    out.name = "slowly_turned";
    return out;
  }();
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto next = lie_euler::step(system, mu, w);
    const double angle = 1e-3 * w.dt;
    const S c(std::cos(angle)), s(std::sin(angle));
    auto out = next;
    out[0] = c * next[0] + s * next[2];
    out[2] = c * next[2] - s * next[0];
    return out;
  }
};

TEST(BiasOfAllMeans, ADriftThatTheMeanOfTheEnergyDoesNotTellIsRefutedInTheOthers) {
  const auto r =
      quick_report(bind(load_scene("paper"), make_rigid_body, scheme_list<slowly_turned>{}), report_stationary_bias);
  const auto& v = r.verdicts.at(0);
  EXPECT_EQ(v.kind, report::verdict_kind::refuted) << v.reason;
  EXPECT_EQ(v.reason.substr(0, 25), "wrong limit: at dt = 0 pi") << v.reason;
  int rows = 0;
  for (const auto& m : r.measurements)
    if (m.quantity == "bias at dt = 0" && m.observable == "energy") {
      EXPECT_LT(std::fabs(m.value.value()), 2e-6);
      ++rows;
    }
  EXPECT_EQ(rows, 1);
}

// What vanishes by symmetry, exactly and in every scheme, leaves no verdict open.
TEST(BiasOfAllMeans, MeansThatVanishBySymmetryDecideNothing) {
  const auto r = quick_report(restricted(bind_scene(load_scene("paper")), {"lie_euler"}), report_stationary_bias);
  EXPECT_EQ(r.verdicts.at(0).kind, report::verdict_kind::holds) << r.verdicts.at(0).reason;
  int rows = 0;
  for (const auto& m : r.measurements)
    if (m.quantity == "bias" && (m.observable == "pi1" || m.observable == "pi2" || m.observable == "pi3")) {
      EXPECT_LT(*m.value, 1e-12) << m.observable;
      ++rows;
    }
  EXPECT_GE(rows, 3 * 5);
}

}  // namespace
}  // namespace polhode
