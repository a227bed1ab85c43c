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
  EXPECT_EQ(judge(1, 1, HUGE_VAL, 0.1), inconclusive);
  EXPECT_EQ(judge(1, 2, HUGE_VAL, 0.1), inconclusive);
}

// An end on the margin is inside; an interval that touches it there alone is not disjoint.
TEST(Judge, MarginsBelongToTheClaim) {
  using enum report::verdict_kind;
  EXPECT_EQ(judge(1, 0.75, 1.25, 0.25), holds);
  EXPECT_EQ(judge(1, 1.25, 1.5, 0.25), inconclusive);
  EXPECT_EQ(judge(1, 0.5, 0.75, 0.25), inconclusive);
  EXPECT_EQ(judge_distance({0.5, 0.25, 0.75}, 0.75, "").kind, holds);
  EXPECT_EQ(*judge_distance({0.5, 0.25, 0.75}, 0.75, "").expected, 0);
  EXPECT_EQ(judge_distance({0.5, 0.25, 0.75}, 0.7, "").kind, inconclusive);
  EXPECT_EQ(judge_distance({0.5, 0.25, 0.75}, 0.25, "").kind, inconclusive);
  EXPECT_EQ(judge_distance({0.5, 0.25, 0.75}, 0.24, "").kind, refuted);
  EXPECT_EQ(judge_distance({NAN, 0.25, 0.75}, 1, "none").kind, inconclusive);
}

/// With a slope of [low, high] over all levels and another one between the two finest.
order_fit bent(double low, double high, double finest_low, double finest_high) {
  order_fit fit;
  fit.order = (low + high) / 2;
  fit.low = low;
  fit.high = high;
  fit.finest = {(finest_low + finest_high) / 2, finest_low, finest_high};
  fit.asymptotic = true;
  return fit;
}

// Of claims of order one, margins from 0.9 to 1.1.
TEST(Judge, ASlopeThatNearsTheClaimRefutesNothing) {
  using enum report::verdict_kind;
  const auto kind = [](const order_fit& fit) { return judge_order(1, fit, false).kind; };
  EXPECT_EQ(kind(bent(1.4, 1.5, 1.3, 1.35)), refuted);        // nears it, and both refute it
  EXPECT_EQ(kind(bent(1.4, 1.5, 1.05, 1.35)), inconclusive);  // the finest reach it
  EXPECT_EQ(kind(bent(0.5, 0.6, 0.7, 0.95)), inconclusive);
  EXPECT_EQ(kind(bent(0.5, 0.6, 0.4, 0.85)), refuted);
  auto open = bent(1.4, 1.5, 1.3, 1.35);
  open.asymptotic = false;
  EXPECT_EQ(kind(open), inconclusive);
  open.finest = {1.45, 1.4, 1.5};
  EXPECT_EQ(kind(open), refuted);  // no nearer
  open.finest = {1.6, 1.5, 1.7};
  EXPECT_EQ(kind(open), refuted);
  open = bent(0.5, 0.6, 0.55, 0.65);
  open.asymptotic = false;
  EXPECT_EQ(kind(open), inconclusive);
  open.finest = {0.5, 0.45, 0.55};
  EXPECT_EQ(kind(open), refuted);
  open = bent(1.2, 1.4, 0.9, 1.0);  // inside: no distance at all
  open.asymptotic = false;
  EXPECT_EQ(kind(open), inconclusive);
}

TEST(Judge, OfABoundThatIsKeptFromAboveTheWholeIntervalCounts) {
  using enum report::verdict_kind;
  EXPECT_EQ(judge_order(1, bent(1 - order_margin, 1.5, 0.9, 1.5), true).kind, holds);
  EXPECT_EQ(judge_order(1, bent(0.85, 1.5, 0.9, 1.5), true).kind, inconclusive);
  auto touching = bent(1 + order_margin, 1.5, 0.9, 1.0);
  touching.asymptotic = false;
  EXPECT_EQ(judge_order(1, touching, true).reason.find("not settled"), std::string::npos);
  auto fast = bent(1.2, 1.5, 1.2, 1.5);
  fast.asymptotic = false;
  EXPECT_EQ(judge_order(1, fast, true).kind, inconclusive);
  EXPECT_NE(judge_order(1, fast, true).reason.find("faster than claimed, and not settled"), std::string::npos);
  EXPECT_EQ(judge_order(1, bent(0.5, 0.6, 0.5, 0.6), true).kind, refuted);
  const auto open = judge_order(NAN, bent(0.5, 0.6, 0.5, 0.6), true);
  EXPECT_EQ(open.kind, skipped);
  EXPECT_FALSE(open.expected);
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

// From 0.3 above the margin to 0.4 below it: farther off.
TEST(Judge, ASlopeThatFallsFarBelowTheClaimDoesNotNearIt) {
  auto fit = bent(1.4, 1.5, 0.4, 0.5);
  fit.asymptotic = false;
  EXPECT_EQ(judge_order(1, fit, false).kind, report::verdict_kind::refuted);
  fit.finest = {0.65, 0.6, 0.7};
  EXPECT_EQ(judge_order(1, fit, false).kind, report::verdict_kind::inconclusive);
}

order_fit sampled_order(double order, double half) {
  return {
      order, order - half, order + half, 1, std::vector<bool>(5, true), "", true, {order, order - half, order + half}};
}

// Of 3000 true claims one was 0.753 +- 0.1: 2.9 standard errors beyond the margin.
TEST(Judge, ASampledOrderIsRefutedBeyondAllChance) {
  using enum report::verdict_kind;
  const auto of = [](double order, double half) { return judge_sampled_order(1, sampled_order(order, half)); };
  EXPECT_EQ(of(1.02, 0.06).kind, holds);
  EXPECT_EQ(of(1.6, 0.06).kind, holds);
  EXPECT_EQ(of(0.95, 0.08).kind, inconclusive);
  EXPECT_EQ(of(0.753, 0.0999).kind, inconclusive);
  EXPECT_NE(of(0.753, 0.0999).reason.find("by 2.9 standard errors, of which 5.3 would refute"), std::string::npos);
  EXPECT_EQ(of(0.5, 0.0999).kind, refuted);
  EXPECT_EQ(of(0.5, 0.11).kind, inconclusive);
  EXPECT_NE(of(0.5, 0.11).reason.find("wider than the margin of 0.1"), std::string::npos);
  const double half = 0.4 * 1.96 / 5.33;  // 0.5 is 0.4 beyond the margin
  ASSERT_GT(half, 0.1);
  EXPECT_EQ(of(0.7, half / 2 * 0.999).kind, refuted);
  EXPECT_EQ(of(0.7, half / 2 * 1.001).kind, inconclusive);
  EXPECT_EQ(judge_sampled_order(1, {}).kind, inconclusive);
  EXPECT_EQ(judge_sampled_order(NAN, sampled_order(1, 0.05)).kind, skipped);
  EXPECT_EQ(judge_sampled_order(NAN, sampled_order(1, 0.5)).kind, skipped);
}

}  // namespace
}  // namespace polhode
