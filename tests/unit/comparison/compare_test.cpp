// SPDX-License-Identifier: Apache-2.0
// Comparing two results: what is noise, what is not, and what is worse.
#include "comparison/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/comparison_text.hpp"
#include "reports/writers/digest.hpp"
#include "reports/writers/json.hpp"
#include "unit/comparison/results_by_hand.hpp"

namespace polhode {
namespace {

using report::change_kind;
using report::verdict_kind;
using test::number;
using test::with;

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

TEST(Compare, ADigestStandsForItsResult) {
  for (const char* method : {"sampled", "transfer"}) {
    const double half = method == std::string("sampled") ? 0.01 : 0;
    const auto run = [&](double coarse, double fine, verdict_kind kind) {
      return with({number(coarse, half, method, 0.5), number(fine, half, method, 0.25)}, {claim(kind)});
    };
    const auto before = run(2 / 3., 1 / 3., verdict_kind::holds);
    const auto digest = report::from_json(report::to_digest(before));
    const auto same = compare(digest, before);
    EXPECT_TRUE(same.changes.empty()) << method;
    EXPECT_EQ(same.numbers, 1u) << "the error at the last level";
    EXPECT_EQ(same.claims, 1u);
    EXPECT_EQ(kinds(digest, run(2 / 3., 0.38, verdict_kind::holds)), none{change_kind::worse});
    EXPECT_EQ(kinds(digest, run(2 / 3., 0.28, verdict_kind::holds)), none{change_kind::better});
    EXPECT_EQ(kinds(digest, run(2 / 3., 1 / 3., verdict_kind::refuted)), none{change_kind::worse});
    EXPECT_EQ(kinds(run(2 / 3., 0.28, verdict_kind::holds), digest), none{change_kind::worse});
  }
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

TEST(Compare, NamesFromOutsideDoNotReachTheTerminalAsTheyAre) {
  auto before = with({}), after = with({});
  before.scene.name = "a\x1b[2Jb\n\x7f";
  after.scene.system = "spin";
  try {
    compare(before, after);
    FAIL();
  } catch (const input_error& e) {
    EXPECT_TRUE(is_plain_text(e.what())) << e.what();
  }
}

}  // namespace
}  // namespace polhode
