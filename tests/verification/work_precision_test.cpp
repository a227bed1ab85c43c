// SPDX-License-Identifier: Apache-2.0
// Cost against error: the front is one, the table lies between what was measured, and the counts are the known ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "experiments/work_precision/cost_front.hpp"
#include "experiments/work_precision/step_cost.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

cost_point point(const std::string& scheme, double dt, double error, double cost) {
  return {scheme, dt, error, error, error, cost, cost, cost};
}

report::results work_precision_on_paper(int threads = 2) {
  return test::quick_results(load_scene("paper"), {"energy", "casimir", "work_precision"},
                             {"heun", "strang", "milstein"}, threads);
}

bool timed(const report::measurement& m) { return m.method == "timed"; }

TEST(CostFront, HoldsNoPointThatAnotherBeatsAndLeavesOutNoneThatIsUnbeaten) {
  std::mt19937 draw(1);
  std::lognormal_distribution<double> size(0, 2);
  std::vector<cost_point> all;
  for (int i = 0; i < 300; ++i) all.push_back(point("any", 1, size(draw), size(draw)));
  mark_front(all);
  for (const auto& p : all) {
    const bool beaten = std::ranges::any_of(all, [&](const auto& o) { return o.error < p.error && o.cost < p.cost; });
    EXPECT_EQ(p.front, !beaten);
  }
}

TEST(CostFront, AnErrorLostInItsUncertaintyBeatsNothing) {
  std::vector<cost_point> all{point("resolved", 1, 1e-3, 2), point("lost", 1, 1e-9, 1)};
  all[1].error_low = 0;
  all[1].error_high = 1e-2;
  mark_front(all);
  EXPECT_TRUE(all[0].front);
  EXPECT_FALSE(all[1].front);
  EXPECT_FALSE(reach({all[1]}, 1e-3));
}

TEST(Reach, InterpolatesAPowerLawAndNothingBeyondIt) {
  std::vector<cost_point> line;
  for (const double dt : {0.5, 0.25, 0.125}) line.push_back(point("second", dt, dt * dt, 3 / dt));
  const auto found = reach(line, 0.04);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->dt, 0.2, 1e-12);
  EXPECT_NEAR(found->cost, 15, 1e-9);
  EXPECT_FALSE(found->coarsest);
  EXPECT_FALSE(reach(line, 0.01));
  EXPECT_TRUE(reach(line, 0.5)->coarsest);
  EXPECT_EQ(reach(line, 0.5)->dt, 0.5);
}

TEST(Reach, ALevelThatIsAccurateByAccidentDoesNotCount) {
  const std::vector<cost_point> dip{point("dip", 1, 1e-9, 1), point("dip", 0.5, 1e-2, 2), point("dip", 0.25, 1e-4, 4)};
  const auto found = reach(dip, 1e-3);
  ASSERT_TRUE(found);
  EXPECT_GT(found->dt, 0.25);
  EXPECT_LT(found->dt, 0.5);
}

TEST(StepCost, CountsTheNormalsOfAStep) {
  auto scene = load_scene("paper");
  const auto normals = [&](const char* name) {
    const auto s = bind_scene(scene);
    const auto scheme = std::ranges::find(s.schemes, name, [](const auto& e) { return e.info.name; });
    const auto cost = cost_of_step({s}, *scheme, 0.01);
    EXPECT_GT(cost.ns, 0);
    EXPECT_LE(cost.low, cost.ns);
    EXPECT_GE(cost.high, cost.ns);
    return cost.normals;
  };
  EXPECT_EQ(normals("heun"), 3);
  EXPECT_EQ(normals("milstein"), 6);
  scene.vectors("sigma").clear();
  EXPECT_EQ(normals("heun"), 0);
  EXPECT_EQ(normals("milstein"), 0);
}

TEST(WorkPrecision, EveryEntryOfTheTableLiesBetweenMeasuredNeighbours) {
  const auto r = work_precision_on_paper();
  int entries = 0;
  for (const auto& m : r.measurements) {
    if (m.quantity != "cost_to_reach" || !m.value) continue;
    ++entries;
    std::map<double, double> costs;
    for (const auto& c : r.measurements)
      if (c.quantity == "cost" && c.scheme == m.scheme && c.observable == m.observable) costs[*c.dt()] = *c.value;
    const auto coarse = costs.lower_bound(*m.dt() * (1 - 1e-12)),
               fine = std::prev(costs.upper_bound(*m.dt() * (1 + 1e-12)));
    ASSERT_NE(coarse, costs.end());
    EXPECT_LE(std::min(coarse->second, fine->second) * (1 - 1e-9), *m.value) << m.scheme << " " << m.observable;
    EXPECT_GE(std::max(coarse->second, fine->second) * (1 + 1e-9), *m.value) << m.scheme << " " << m.observable;
  }
  EXPECT_GT(entries, 10);
}

TEST(WorkPrecision, DecidesNothingByTheClock) {
  const auto r = work_precision_on_paper();
  const auto of_cost = [](const auto& row) { return row.experiment == "work_precision"; };
  EXPECT_TRUE(std::ranges::any_of(r.measurements, of_cost));
  for (const auto& v : r.verdicts) EXPECT_TRUE(!of_cost(v) || v.kind == report::verdict_kind::skipped) << v.reason;
}

TEST(WorkPrecision, IsTheSameForAnyNumberOfThreadsButForTheClock) {
  const auto one = work_precision_on_paper(1), three = work_precision_on_paper(3);
  const auto counted = [](const report::results& r) {
    std::map<std::string, double> rows;
    for (const auto& m : r.measurements)
      if (m.experiment == "work_precision" && !timed(m))
        rows[m.scheme + m.quantity + m.observable + std::to_string(*m.dt())] = *m.value;
    return rows;
  };
  EXPECT_FALSE(counted(one).empty());
  EXPECT_EQ(counted(one), counted(three));
  EXPECT_EQ(one.done.work, three.done.work);
}

TEST(WorkPrecision, SaysWhoseErrorsItMisses) {
  verify_options options;
  options.schemes = {"heun"};
  options.experiments = {"work_precision"};
  options.effort = effort::quick;
  const auto r = verify(load_scene("paper"), options);
  ASSERT_EQ(r.skipped.size(), 1U);
  EXPECT_NE(r.skipped[0].reason.find("strong,weak,gibbs,energy,casimir"), std::string::npos) << r.skipped[0].reason;
}

}  // namespace
}  // namespace polhode
