// SPDX-License-Identifier: Apache-2.0
// What a run does not decide stands in the report, for every scheme and with the reason.
#include "experiments/common/undecided.hpp"

#include <gtest/gtest.h>

#include "run/bind_scene.hpp"
#include "run/run_experiment.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

struct Undecided : testing::Test {
  subject s = restricted(bind_scene(load_scene("paper")), {"heun", "strang"});
  report::results out;

  void expect_of_both(verdict_kind kind, const std::string& reason) const {
    ASSERT_EQ(out.verdicts.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& v = out.verdicts[i];
      EXPECT_EQ(v.scheme, i == 0 ? "heun" : "strang");
      EXPECT_EQ(v.experiment, "gibbs");
      EXPECT_EQ(v.claim, "a claim");
      EXPECT_EQ(v.kind, kind);
      EXPECT_EQ(v.reason, reason);
    }
  }

  /// Of something that takes so much, where the efforts afford 10, 100 and 1000.
  bool affords_work(double work) {
    const context c{.subject = s, .effort = effort::quick};
    return affords(c, s.schemes,
                   {"gibbs", "a claim", "forgetting", "steps", work,
                    [](effort e) { return e == effort::quick      ? 10.0
                                          : e == effort::standard ? 100.0
                                                                  : 1000.0; }},
                   out);
  }
};

TEST_F(Undecided, LeftOpenIsInconclusiveForEveryScheme) {
  leave_open(s.schemes, "gibbs", "a claim", "why", out);
  expect_of_both(verdict_kind::inconclusive, "why");
}

TEST_F(Undecided, LeftUntriedIsNotTried) {
  leave_untried(s.schemes, "gibbs", "a claim", "why", out);
  expect_of_both(verdict_kind::not_tried, "why");
}

TEST_F(Undecided, WhatIsAffordedIsNotMentioned) {
  EXPECT_TRUE(affords_work(10));
  EXPECT_TRUE(out.verdicts.empty());
}

TEST_F(Undecided, WhatAHigherEffortAffordsIsNotTriedAndTheFirstOfThemNamed) {
  EXPECT_FALSE(affords_work(11));
  expect_of_both(verdict_kind::not_tried,
                 "forgetting takes 11 steps, at most 10 are affordable; tried at effort standard");
}

TEST_F(Undecided, WhatNoEffortAffordsIsInconclusive) {
  EXPECT_FALSE(affords_work(2000));
  expect_of_both(verdict_kind::inconclusive,
                 "forgetting takes 2e+03 steps, at most 10 are affordable, 1e+03 at effort thorough");
}

}  // namespace
}  // namespace polhode
