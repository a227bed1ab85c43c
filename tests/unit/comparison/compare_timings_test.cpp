// SPDX-License-Identifier: Apache-2.0
// Comparing costs: what a noisy machine does to them is no change, and what a program does is.
#include "comparison/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "unit/comparison/results_by_hand.hpp"

namespace polhode {
namespace {

using report::change_kind;
using test::with;

/// Costs of a run as a noisy machine times them: `speed` slows everything, the yardstick with it, and a neighbour on
/// the same core slows the yardstick most; `run` is what this run does to each scheme alone; each cost has its own
/// noise, which its interval knows.
struct machine {
  std::mt19937_64 random;
  double own_noise = 0.006, placement = 0.003;  // of a busy machine
  double speeds = 0.1;
  double neighbour = 0;  // by how much it slows the yardstick, in log

  report::results timed(double slower_scheme = 1, double slower_kernel = 1) {
    std::normal_distribution<double> noise;
    const double speed = std::exp(speeds * noise(random));
    std::uniform_real_distribution<double> share;
    report::results r = with({});
    const auto add = [&](const char* scheme, const char* quantity, const char* kind, double dt, double value,
                         double error) {
      report::measurement m{"work_precision", scheme, quantity, kind, value, {}, {}, "ns", "timed"};
      if (dt > 0) m.set_over({report::step_size, dt, "time"});
      m.low = value * std::exp(-1.96 * error);
      m.high = value * std::exp(1.96 * error);
      r.measurements.push_back(m);
    };
    add("", "yardstick", "", 0, 1.3 * speed * std::exp(neighbour), 0.02);
    for (const char* scheme : {"euler", "heun", "lie_heun", "magnus", "milstein", "strang", "implicit"})
      for (const bool silent : {false, true}) {
        const double run = placement * noise(random) + neighbour * share(random);
        const bool planted = scheme == std::string("heun");
        const double slower = !planted ? 1 : silent ? slower_scheme * slower_kernel : slower_scheme;
        for (int level = 0; level < 9; ++level) {
          const double dt = std::ldexp(0.5, -level);
          const double cost = speed * slower / dt * std::exp(run + own_noise * noise(random));
          add(scheme, "cost", silent ? "energy_law" : "weak", dt, cost, own_noise);
          if (!silent) add(scheme, "cost", "strong", dt, cost, own_noise);  // the same step for another goal
        }
      }
    return r;
  }
};

TEST(CompareTimings, RunsOfOneProgramDifferInOneOfAHundredAtMost) {
  machine m{std::mt19937_64(7)};
  int alarms = 0;
  for (int pair = 0; pair < 500; ++pair) alarms += !compare(m.timed(), m.timed()).changes.empty();
  EXPECT_LE(alarms, 12);  // 5 expected at most, 3 standard deviations
}

TEST(CompareTimings, AnotherStateOfTheMachineIsNoChange) {
  machine quiet{std::mt19937_64(14), 0.006, 0.003, 0.03}, busy{std::mt19937_64(15), 0.006, 0.003, 0.03, 0.4};
  int alarms = 0, told = 0;
  for (int pair = 0; pair < 200; ++pair) {
    const auto c = compare(quiet.timed(), busy.timed());
    alarms += !c.changes.empty();
    for (const auto& s : c.settings) told += s.find("the machine's state") != std::string::npos;
  }
  EXPECT_GE(told, 196);  // but where the schemes happen to be slowed alike
  EXPECT_LE(alarms, 6);  // 2 expected at most, 3 standard deviations
}

TEST(CompareTimings, AFivePerCentSlowerSchemeIsOneLine) {
  machine m{std::mt19937_64(8), 0.004, 0.003, 0};
  int found = 0, lines = 0;
  for (int pair = 0; pair < 200; ++pair) {
    const auto changes = compare(m.timed(), m.timed(1.05)).changes;
    lines += static_cast<int>(changes.size());
    for (const auto& c : changes) {
      EXPECT_EQ(c.kind, change_kind::different);
      found += c.scheme == "heun" && *c.after > 1.03 && *c.after < 1.07;
    }
  }
  EXPECT_GE(found, 198);
  EXPECT_LE(lines, found + 4);
}

TEST(CompareTimings, AFivePerCentSlowerKernelIsFoundWhereNoNoiseIsDrawn) {
  machine m{std::mt19937_64(9), 0.004, 0.003, 0};
  int found = 0;
  for (int pair = 0; pair < 100; ++pair)
    for (const auto& c : compare(m.timed(), m.timed(1, 1.05)).changes)
      found += c.scheme == "heun" && c.what.find("without noise") != std::string::npos;
  EXPECT_GE(found, 98);
}

TEST(CompareTimings, OneStepSizeThatGoesItsOwnWayIsTold) {
  machine m{std::mt19937_64(10)};
  const auto before = m.timed();
  auto after = m.timed();
  for (auto& row : after.measurements)
    if (row.scheme == "strang" && row.dt() == 0.125)
      for (auto* x : {&row.value, &row.low, &row.high}) **x *= 1.4;
  const auto changes = compare(before, after).changes;
  ASSERT_EQ(changes.size(), 2u);  // with noise, and without
  EXPECT_EQ(changes[0].scheme, "strang");
  EXPECT_EQ(changes[0].dt, 0.125);
}

TEST(CompareTimings, WhatAllSchemesHaveInCommonIsOneLine) {
  machine m{std::mt19937_64(13), 0.006, 0.003, 0};
  const auto before = m.timed();
  auto after = m.timed();
  for (auto& row : after.measurements)
    if (row.quantity == "cost")
      for (auto* x : {&row.value, &row.low, &row.high}) **x *= 1.5;
  const auto changes = compare(before, after).changes;
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].scheme, "");
  EXPECT_NE(changes[0].what.find("common to 7 schemes"), std::string::npos) << changes[0].what;
}

TEST(CompareTimings, OfAnotherMachineAreLeftOutAndThatIsSaid) {
  machine m{std::mt19937_64(11)};
  const auto before = m.timed();
  auto after = m.timed();
  EXPECT_EQ(compare(before, after).timings, 7u * 2 * 9);
  after.provenance.cpu = "another";
  const auto c = compare(before, after);
  EXPECT_EQ(c.timings, 0u);
  EXPECT_FALSE(c.timings_left_out.empty());
  EXPECT_EQ(c.settings.size(), 1u);
}

TEST(CompareTimings, WithoutAYardstickTheyAreLeftOutAndThatIsSaid) {
  machine m{std::mt19937_64(12)};
  auto before = m.timed();
  std::erase_if(before.measurements, [](const auto& row) { return row.quantity == "yardstick"; });
  const auto c = compare(before, m.timed(2));
  EXPECT_TRUE(c.changes.empty());
  EXPECT_NE(c.timings_left_out.find("earlier run has no yardstick"), std::string::npos) << c.timings_left_out;
}

}  // namespace
}  // namespace polhode
