// SPDX-License-Identifier: Apache-2.0
// Mean squares beside the equilibria: every scheme's rate of growth tends to that of the equation, and of a scheme with
// a little more noise or dissipation it does not.
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/stability/mean_square_report.hpp"
#include "mutants/defect.hpp"
#include "scene/scene.hpp"

namespace polhode::test {
namespace {

using report::verdict_kind;
constexpr const char* schemes[] = {
    "euler_maruyama",    "heun",      "heun_projected", "milstein",    "milstein_no_area",
    "implicit_midpoint", "lie_euler", "lie_heun",       "cayley_heun", "magnus",
    "lie_trotter",       "strang",    "strang_weak2"};

report::verdict judged(const report::scene& scene, std::string_view scheme, const defect& d) {
  const auto s = planted(scene, scheme, d);
  const context c{s, effort::quick, 1, 1};
  report::results out;
  recorder record("stability", scheme, out);
  report_mean_square(c, record);
  EXPECT_EQ(out.verdicts.size(), 1U);
  return out.verdicts.empty() ? report::verdict{} : out.verdicts.front();
}

TEST(MeanSquare, HealthySchemesGrowAsTheEquationDoes) {
  for (const char* scene : {"paper", "anisotropic", "undamped"})
    for (const auto* scheme : schemes) {
      const auto v = judged(load_scene(scene), scheme, {});
      EXPECT_EQ(v.kind, verdict_kind::holds) << scene << ", " << scheme << ": " << v.reason;
    }
}

TEST(MeanSquare, MoreNoiseOrDissipationIsRefuted) {
  for (const auto* scheme : schemes)
    for (const auto kind : {kind::noise, kind::theta})
      for (const double size : {0.05, -0.001}) {
        const auto v = judged(load_scene("paper"), scheme, {kind, size});
        EXPECT_EQ(v.kind, verdict_kind::refuted) << scheme << ", " << described({kind, size}) << ": " << v.reason;
      }
}

TEST(MeanSquare, AnOrderTooMuchIsRefuted) {
  for (const auto* scheme : schemes) {
    const auto v = judged(load_scene("paper"), scheme, {kind::weak_claim, 1});
    EXPECT_EQ(v.kind, verdict_kind::refuted) << scheme << ": " << v.reason;
  }
}

TEST(MeanSquare, WithoutNoiseNothingIsSaid) {
  auto s = load_scene("paper");
  s.vectors("sigma").clear();
  const auto bound = planted(s, "strang", {});
  const context c{bound, effort::quick, 1, 1};
  report::results out;
  recorder record("stability", "strang", out);
  report_mean_square(c, record);
  EXPECT_TRUE(out.verdicts.empty());
}

}  // namespace
}  // namespace polhode::test
