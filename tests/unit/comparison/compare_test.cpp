// Comparing two results: what is noise, what is not, and what is worse.
#include "comparison/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "reports/model/errors.hpp"
#include "reports/writers/comparison_text.hpp"

namespace polhode {
namespace {

using report::change_kind;
using report::verdict_kind;

report::measurement number(double value, double half, const std::string& method, double dt = 0.5) {
  report::measurement m{"strong", "heun", "error", "state", value, value - half, value + half, "|mu|", method};
  m.set_over({report::step_size, dt, "time"});
  m.used = true;
  return m;
}

report::results with(std::vector<report::measurement> numbers, std::vector<report::verdict> verdicts = {}) {
  report::results r;
  r.scene = {"s", "rigid_body", {}, {1, 0, 0}, 2, {4}};
  r.scene.vector("inertia") = {1, 2, 3};
  r.scene.number("theta") = 0.5;
  r.scene.vectors("sigma") = {{0.5, 0, 0}};
  r.schemes.resize(1);
  r.schemes[0].name = "heun";
  r.experiments = {{"strong", "?", {}}};
  r.measurements = std::move(numbers);
  r.fits = {{"strong", "heun", "error", "state", report::step_size, 0.5, 0.4, 0.6, 1, ""}};
  r.verdicts = std::move(verdicts);
  return r;
}

report::verdict claim(verdict_kind kind) { return {"strong", "heun", "strong order", 0.5, 0.5, 0.4, 0.6, kind, "why"}; }

std::vector<change_kind> kinds(const report::results& a, const report::results& b) {
  std::vector<change_kind> out;
  for (const auto& c : compare(a, b).changes) out.push_back(c.kind);
  return out;
}
using none = std::vector<change_kind>;

TEST(Compare, NothingHasChangedInTheSame) {
  const auto r = with({number(1, 0.1, "sampled")}, {claim(verdict_kind::holds)});
  const auto c = compare(r, r);
  EXPECT_TRUE(c.changes.empty() && c.settings.empty());
  EXPECT_EQ(c.claims, 1u);
  EXPECT_EQ(c.numbers, 1u);
}

TEST(Compare, AnErrorThatGrowsBeyondItsIntervalIsWorse) {
  const auto before = with({number(1, 0.1, "sampled")});
  EXPECT_EQ(kinds(before, with({number(1.1, 0.1, "sampled")})), none{});
  EXPECT_EQ(kinds(before, with({number(1.2, 0.1, "sampled")})), none{change_kind::worse});
  EXPECT_EQ(kinds(before, with({number(0.8, 0.1, "sampled")})), none{change_kind::better});
}

TEST(Compare, AGrowthLawHasManyNumbersAtOneStepSize) {
  auto first = number(1, 0.1, "sampled"), second = number(3, 0.1, "sampled");
  first.set_over({report::step_count, 1000});
  second.set_over({report::step_count, 2000});
  const auto before = with({first, second});
  EXPECT_EQ(kinds(before, before), none{});
  second.value = *second.value + 1;
  const auto changes = compare(before, with({second, first})).changes;
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].what, "error of state, steps = 2000");
  EXPECT_EQ(changes[0].before, 3);
}

TEST(Compare, AnIntervalWithOneEndIsNoise) {
  auto first = number(1, 0.1, "sampled"), second = number(1.1, 0.1, "sampled");
  first.low = second.low = std::nullopt;
  EXPECT_EQ(kinds(with({first}), with({second})), none{});
  second.value = *second.value + 1, second.high = *second.high + 1;
  EXPECT_EQ(kinds(with({first}), with({second})), none{change_kind::worse});
}

TEST(Compare, WhatIsOfUnknownNoiseIsCountedApart) {
  auto first = number(1, 0.1, "sampled"), second = number(2, 0.1, "sampled");
  first.low = first.high = std::nullopt;
  const auto c = compare(with({first}), with({second}));
  EXPECT_TRUE(c.changes.empty());
  EXPECT_EQ(c.numbers, 0u);
  EXPECT_EQ(c.without_interval, 1u);
  second.value = std::nullopt, second.status = "not finite";
  EXPECT_EQ(kinds(with({first}), with({second})), none{change_kind::worse});
}

TEST(Compare, CopiesAreJudgedWhereTheyWereMeasured) {
  const auto copy = [](double value) {
    auto m = number(value, 0.1, "strong");
    m.experiment = "work_precision";
    return m;
  };
  EXPECT_EQ(kinds(with({copy(1)}), with({copy(2)})), none{});
}

TEST(Compare, ExactNumbersChangeBeyondTheirUncertainty) {
  const auto before = with({number(1, 1e-6, "transfer")});
  EXPECT_EQ(kinds(before, with({number(1 + 1.9e-6, 1e-6, "transfer")})), none{});
  EXPECT_EQ(kinds(before, with({number(1 + 2.1e-6, 1e-6, "transfer")})), none{change_kind::worse});
  EXPECT_EQ(kinds(with({number(1, 0, "exact")}), with({number(1 + 1e-12, 0, "exact")})), none{});
}

TEST(Compare, ANumberThatIsNoErrorIsDifferentNotWorse) {
  auto before = with({number(1, 0, "exact")}), after = with({number(2, 0, "exact")});
  before.fits.clear();
  after.fits.clear();
  EXPECT_EQ(kinds(before, after), none{change_kind::different});
}

TEST(Compare, AnErrorThatIsNoLongerFiniteIsWorse) {
  auto after = with({number(1, 0.1, "sampled")});
  after.measurements[0].value = after.measurements[0].low = after.measurements[0].high = std::nullopt;
  after.measurements[0].status = "not finite";
  const auto found = compare(with({number(1, 0.1, "sampled")}), after).changes;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, change_kind::worse);
  EXPECT_EQ(found[0].text_after, "not finite");
}

TEST(Compare, VerdictsByWhatTheyWere) {
  const auto of = [](verdict_kind a, verdict_kind b) { return kinds(with({}, {claim(a)}), with({}, {claim(b)})); };
  EXPECT_EQ(of(verdict_kind::holds, verdict_kind::refuted), none{change_kind::worse});
  EXPECT_EQ(of(verdict_kind::skipped, verdict_kind::refuted), none{change_kind::worse});
  EXPECT_EQ(of(verdict_kind::holds, verdict_kind::inconclusive), none{change_kind::unsure});
  EXPECT_EQ(of(verdict_kind::refuted, verdict_kind::inconclusive), none{change_kind::better});
  EXPECT_EQ(of(verdict_kind::inconclusive, verdict_kind::holds), none{change_kind::better});
}

TEST(Compare, AClaimThatIsMadeNoLongerIsNotedUnlessItWasNotAsked) {
  const auto before = with({}, {claim(verdict_kind::holds)});
  auto after = with({});
  EXPECT_EQ(kinds(before, after), none{change_kind::unsure});
  after.experiments.clear();
  EXPECT_EQ(kinds(before, after), none{});
}

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
    if (row.scheme == "strang" && row.dt == 0.125)
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

TEST(Compare, NumbersThatMoveTogetherAreOneLine) {
  std::vector<report::measurement> before, after;
  for (int i = 0; i < 40; ++i) {
    before.push_back(number(1, 0.01, "sampled", i));
    after.push_back(number(i == 7 ? 3 : 2, 0.01, "sampled", i));
  }
  const auto c = compare(with(before), with(after));
  EXPECT_EQ(c.changes.size(), 40u);
  const auto text = report::to_text(c);
  EXPECT_NE(text.find("worse: 40\n"), std::string::npos) << text;
  EXPECT_NE(text.find("dt = 7: 1"), std::string::npos) << text;
  EXPECT_NE(text.find("and 39 more of its numbers"), std::string::npos) << text;
  EXPECT_EQ(std::ranges::count(text, '\n'), 4) << text;
}

/// Two honest runs with other seeds: of all their numbers together none is called changed in 95 of 100 comparisons.
TEST(Compare, IndependentRunsAgree) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise;
  int alarms = 0;
  for (int run = 0; run < 400; ++run) {
    std::vector<report::measurement> a, b;
    for (int i = 0; i < 300; ++i) {
      a.push_back(number(10 + noise(random), 1.96, "sampled", i));
      b.push_back(number(10 + noise(random), 1.96, "sampled", i));
    }
    alarms += !compare(with(a), with(b)).changes.empty();
  }
  EXPECT_LE(alarms, 35);  // 20 expected, 3.4 standard deviations
  EXPECT_GE(alarms, 5);   // and the test is not blind
}

TEST(Compare, OtherScenesAreRefusedByTheKeyThatDiffers) {
  auto after = with({});
  after.scene.number("theta") = 0.25;
  try {
    compare(with({}), after);
    FAIL();
  } catch (const input_error& e) {
    EXPECT_NE(std::string(e.what()).find("theta"), std::string::npos);
  }
}

}  // namespace
}  // namespace polhode
