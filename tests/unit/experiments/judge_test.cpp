// SPDX-License-Identifier: Apache-2.0
// From an interval to a verdict.
#include "experiments/common/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "statistics/orders/order_fit.hpp"
#include "support/halvings.hpp"

namespace polhode {
namespace {

using test::halvings;

TEST(Judge, IntervalsDecide) {
  using enum report::verdict_kind;
  EXPECT_EQ(judge(1, 0.95, 1.05, 0.1), holds);
  EXPECT_EQ(judge(1, 0.85, 1.05, 0.1), inconclusive);
  EXPECT_EQ(judge(1, 0.4, 0.6, 0.1), refuted);
  EXPECT_EQ(judge(1, 1.2, 1.3, 0.1), refuted);
  EXPECT_EQ(judge(1, NAN, 1, 0.1), inconclusive);
}

TEST(Judge, FasterThanClaimedHoldsOnlyWhereTheClaimIsABound) {
  order_fit fit;
  fit.order = 3;
  fit.low = 2.98;
  fit.high = 3.02;
  fit.finest = {3, 2.98, 3.02};
  EXPECT_EQ(judge_order(2, fit, true).kind, report::verdict_kind::holds);
  EXPECT_EQ(judge_order(2, fit, false).kind, report::verdict_kind::refuted);
  EXPECT_EQ(judge_order(2, std::nullopt, true).kind, report::verdict_kind::inconclusive);
}

// Two powers that cross inside the levels, the slower one below: the slope there is that of neither.
TEST(Judge, ASlopeThatStillChangesRefutesNothing) {
  const auto dt = halvings(4);
  std::vector<double> crossing, straight;
  for (const double h : dt) {
    crossing.push_back(h + 20 * h * h);
    straight.push_back(std::pow(h, 1.5));
  }
  const auto bent = fit_order(dt, crossing, 0), line = fit_order(dt, straight, 0);
  EXPECT_FALSE(bent->asymptotic);
  EXPECT_TRUE(line->asymptotic);
  auto refuting = *bent;
  refuting.low = 1.4;
  refuting.high = 1.6;
  EXPECT_EQ(judge_order(1, refuting, false).kind, report::verdict_kind::inconclusive);
  EXPECT_EQ(judge_order(1, line, false).kind, report::verdict_kind::refuted);
  refuting = *line;
  refuting.finest = {1.15, 1.05, 1.25};
  EXPECT_EQ(judge_order(1, refuting, false).kind, report::verdict_kind::inconclusive);
}

}  // namespace
}  // namespace polhode
