// SPDX-License-Identifier: Apache-2.0
// `polhode reference` as a function: what it refuses, in words, and how certain its answers are.
#include "run/reference.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "problem/capabilities.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/stationary.hpp"
#include "unit/run/reference_questions.hpp"

namespace polhode::test {
namespace {

TEST(Reference, BadOptionsAreNamed) {
  const auto paper = load_scene("paper");
  refuses(paper, {"", {}, {}, 0}, {"--quantity", "expectation, gibbs, lyapunov, gap"});
  refuses(paper, {"gibs", {}, {}, 0}, {"--quantity 'gibs'", "did you mean 'gibbs'"});
  refuses(paper, {"line\nbreak", {}, {}, 0}, {"--quantity"});
  for (const char* quantity : {"expectation", "gibbs"}) {
    refuses(paper, {quantity, "enrgy", {}, 0}, {"--observable 'enrgy'", "did you mean 'energy'", "exp(pi3)"});
    refuses(paper, {quantity, "", {}, 0}, {"--observable ''", "casimir"});
    refuses(paper, {quantity, "pi4", {}, 0}, {"--observable 'pi4'"});
  }
  for (const int degree : {-1, 129}) refuses(paper, {"gap", {}, {}, degree}, {"--degree", "1 to 128"});
  for (const double time : {-1.0, std::nan(""), HUGE_VAL})
    refuses(paper, {"expectation", {}, time, 0}, {"--time", "at least 0"});
  for (const char* quantity : {"gibbs", "gap", "lyapunov"})
    refuses(paper, {quantity, {}, 1.0, 0}, {"--time '1'", quantity, "expectation"});
  for (const char* quantity : {"gap", "lyapunov"})
    refuses(paper, {quantity, "energy", {}, 0}, {"--observable", quantity});
}

TEST(Reference, WhereNoLawIsUniqueItIsSaid) {
  const auto phase = scene_of({1, 1, 2.5}, 0, {{0, 0, 0.4}});
  refuses(phase, {"gibbs", {}, {}, 0}, {"not unique"});
  refuses(phase, {"lyapunov", {}, {}, 0}, {"not unique"});
}

TEST(Reference, WhatNoDegreeResolvesIsRefusedWithTheDegreeItWouldTake) {
  const auto needle = scene_of({1e-6, 1, 2}, 0.5, half);
  for (const char* quantity : {"expectation", "gap"})
    refuses(needle, {quantity, {}, {}, 0}, {"given", quantity, "not converged", "about 21000 would be needed"});
  EXPECT_NEAR(stationary_mean(scene_of({1e-6, 1, 1}, 0.5, half), "energy"), 0.625, 1e-11);  // the law itself is known
}

TEST(Reference, AForcedDegreeSaysHowFarItIsOff) {
  const auto paper = load_scene("paper");
  const auto rough = reference(paper, {"expectation", {}, {}, 8});
  EXPECT_EQ(rough.degree, 8);
  EXPECT_NE(rough.reason, "");
  EXPECT_GT(rough.uncertainty, 1e-9);
  EXPECT_NEAR(rough.value, 0.281221439758, rough.uncertainty);
  const auto fine = reference(paper, {"expectation", {}, {}, 40});
  EXPECT_EQ(fine.degree, 40);
  EXPECT_EQ(fine.reason, "");
}

// Strong Gibbs factors see the last digit of nearly equal inertias: 1 / (1 / 1.9) is not 1.9.
TEST(Reference, GibbsTakesTheInertiaAsItStands) {
  const double near = 1.9;
  ASSERT_NE(1 / (1 / near), near);
  const three inertia{near * (1 + 1e-9), near, 1.2};
  const double beta = 2e10, theta = 0.5 * beta * 1e-6;
  const auto s = scene_of(inertia, theta, axes(1e-3, 1e-3, 1e-3));
  const gibbs_law law({inertia[0], inertia[1], inertia[2]}, 1, beta);
  for (const int k : {0, 1}) {
    const auto found = ask(s, {"gibbs", fmt::format("pi{}^2", k + 1), {}, 0});
    EXPECT_NEAR(found.value, law.mean_square(k), 1e-11 * law.mean_square(k));
  }
}

TEST(Reference, EveryListedObservableIsAnswered) {
  const auto listed = named_observables();
  EXPECT_EQ(listed.size(), 9u);
  for (const auto& o : listed) {
    const auto f = named_observable(o.name, *bind_scene(load_scene("paper")).sphere());
    ASSERT_TRUE(f) << o.name;
    EXPECT_NEAR(ask(load_scene("paper"), {"expectation", o.name, 0.0, 0}).value, (*f)({0.6, 0.48, 0.64}), 1e-11);
  }
}

}  // namespace
}  // namespace polhode::test
