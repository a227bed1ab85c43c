// SPDX-License-Identifier: Apache-2.0
// Scenes of tests/nightly/modified_attack_test.cpp on which healthy schemes were refuted: rounding of a step's operator
// changes modes slower than the fastest rate by more than was allowed for, and the slowest of two modes has no power
// series.
#include <gtest/gtest.h>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode::test {
namespace {

report::scene slow_gap() {
  auto s = load_scene("paper");
  s.vector("inertia") = {1.8665211073318926, 0.55081471842648455, 0.79646406415099635};
  s.number("theta") = 0;
  s.momentum = {-1.4446109256723749, 0.089227110170224236, 0.90184683515853481};
  s.vectors("sigma") = {{1.5427163952791048, 0.60833281228091485, -0.98422843785298664},
                        {0.23458550330974198, -0.40415533165589562, -0.64789777871693965},
                        {2.0657415671984696, -0.68642389266476767, 0.10003961400760125}};
  return s;
}

report::scene slow_variance() {
  auto s = load_scene("paper");
  s.vector("inertia") = {3.1770211410003415, 3.1770211410003415, 3.198414817841476};
  s.number("theta") = 0.11488984286926794;
  s.momentum = {-1.0225824366206631, 0.55777810222235391, 0.082992472258636693};
  s.vectors("sigma") = {{0.17376089284938512, 0, 0}, {0, 0.17376089284938512, 0}, {0, 0, 0.17376089284938512}};
  return s;
}

/// Two modes nearly as slow: which of them is slower changes at dt = 0.02.
report::scene crossing_modes() {
  auto s = load_scene("paper");
  s.vector("inertia") = {1.0081810440515493, 1.3868449365787996, 2.30803503976};
  s.number("theta") = 0.076000379857113193;
  s.momentum = {0.51990483828754641, 0.94766563037822205, -0.3012322621578632};
  s.vectors("sigma") = {{-0.36325834200393081, 0, 0}, {0, 0.33521914795608321, 0}, {0, 0, -0.22943886870037217}};
  return s;
}

void expect_to_hold(const report::scene& scene, std::string_view scheme, std::string_view claim) {
  auto s = bind_scene(scene);
  s.schemes = {scheme_of(s, scheme)};
  const auto r = quick_results(s, {"modified"});
  const auto& v = verdict_of(r, claim);
  EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.reason;
}

TEST(ModifiedUnderAttack, SlowGapAtFineSteps) { expect_to_hold(slow_gap(), "strang_weak2", "spectral gap converges"); }
TEST(ModifiedUnderAttack, VarianceOfSlowModes) {
  expect_to_hold(slow_variance(), "strang_weak2", "asymptotic variance converges");
}
TEST(ModifiedUnderAttack, GapWhereModesCross) {
  expect_to_hold(crossing_modes(), "lie_euler", "spectral gap converges");
}

}  // namespace
}  // namespace polhode::test
