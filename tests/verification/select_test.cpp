// The choice of an integrator: where it must lead, that what it promises holds, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "reports/model/errors.hpp"
#include "support/selection_check.hpp"

namespace polhode {
namespace {

using namespace test;

TEST(Select, WhatIsChosenMeetsTheTargetOnOtherScenes) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 5; ++i) {
    const auto s = random_scene(random, i);
    for (const auto& o :
         {asking("weak", 1e-4), asking("stationary", 1e-4), asking("energy", 1e-5), asking("strong", 3e-2)}) {
      if (o.goal == "strong" && i >= 2) continue;  // the dearest to check
      const auto found = select(s, o);
      ASSERT_TRUE(found.winner) << o.goal << ": " << found.reason;
      EXPECT_LE(found.winner->bound, o.tolerance);
      EXPECT_LE(measured_again(s, o, *found.winner), o.tolerance) << o.goal << ' ' << found.winner->scheme;
      ASSERT_TRUE(found.runner_up);
      EXPECT_LE(found.winner->cost, found.runner_up->cost);
      EXPECT_EQ(found.rejected.size() + 1, o.goal == "weak" || o.goal == "stationary" ? 14u : 13u);
      EXPECT_NE(found.snippet.find("int main"), std::string::npos);
    }
  }
}

TEST(Select, TightTargetsLeadToHighOrders) {
  const auto chosen = [](const std::string& goal, double tolerance) {
    return select(load_scene("paper"), asking(goal, tolerance)).winner.value().scheme;
  };
  EXPECT_TRUE((std::set<std::string>{"magnus", "milstein"}.contains(chosen("strong", 5e-3))));
  for (const auto* goal : {"weak", "stationary"})
    EXPECT_TRUE((std::set<std::string>{"strang_weak2", "strang_extrapolated"}.contains(chosen(goal, 1e-6)))) << goal;
}

TEST(Select, RequirementsAreKept) {
  auto o = asking("strong", 5e-2);
  o.require = {"no-areas", "casimir-exact"};
  const auto found = select(load_scene("paper"), o);
  ASSERT_TRUE(found.winner);
  for (const auto* name : {"magnus", "milstein", "heun", "euler_maruyama"}) {
    EXPECT_NE(found.winner->scheme, name);
    EXPECT_NE(found.runner_up.value().scheme, name);
  }
  o = asking("energy", 1e-3);
  o.require = {"monotone-energy", "implicit"};
  EXPECT_EQ(select(load_scene("paper"), o).winner.value().scheme, "implicit_midpoint");
}

TEST(Select, NoiseThatIsNotIsotropicHasNoGibbsLaw) {
  auto s = load_scene("paper");
  s.sigma = {{0.4, 0, 0}, {0, 0.6, 0}, {0, 0, 0.8}};
  const auto found = select(s, asking("stationary", 1e-4));
  ASSERT_TRUE(found.winner);
  bool said = false;
  for (const auto& n : found.notes) said = said || n.find("no Gibbs law") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(Select, WhatCannotBeAskedIsRefusedByName) {
  const auto fault = [](const scene& s, const select_options& o) -> std::string {
    try {
      select(s, o);
    } catch (const input_error& e) {
      return e.what();
    }
    return "";
  };
  const auto paper = load_scene("paper");
  const auto expect = [&](const scene& s, const select_options& o, const std::string& part) {
    EXPECT_NE(fault(s, o).find(part), std::string::npos) << fault(s, o);
    EXPECT_EQ(fault(s, o).find('\n'), std::string::npos);
  };
  expect(paper, asking("weak", 0), "--tolerance '0'");
  expect(paper, asking("weak", -1), "--tolerance '-1'");
  expect(paper, asking("weak", 1e-16), "below what double precision can show");
  expect(paper, asking("wek", 1e-3), "did you mean");
  expect(paper, asking("", 1e-3), "--goal is missing");
  auto o = asking("weak", 1e-3);
  o.require = {"explicit", "implicit"};
  expect(paper, o, "contradictory");
  o.require = {"implicit", "no-arias"};
  expect(paper, o, "no-arias");
  o = asking("weak", 1e-3);
  o.observable = "energi";
  expect(paper, o, "energy");
  auto still = paper;
  still.sigma.clear();
  expect(still, asking("weak", 1e-3), "--goal energy");
  EXPECT_TRUE(select(still, asking("energy", 1e-5)).winner);
}

}  // namespace
}  // namespace polhode
