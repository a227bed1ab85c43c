// SPDX-License-Identifier: Apache-2.0
// The search for the largest stable step.
#include <gtest/gtest.h>

#include <functional>

#include "experiments/stability/stability_limit.hpp"

namespace polhode {
namespace {

stability_limit find_limit(const step_range& range, const std::function<bool(std::int64_t)>& stable) {
  limit_search search(range);
  while (const auto steps = search.asks()) search.tell(stable(*steps));
  return search.limit();
}

TEST(StabilityLimit, IsFoundToFivePercentFromEitherSide) {
  for (const std::int64_t edge : {3, 40, 64, 65, 700, 100'000}) {
    const auto b = find_limit({2, 64, 1 << 20}, [&](std::int64_t n) { return n >= edge; });
    EXPECT_GE(b.stable, edge);
    EXPECT_LT(b.broken, edge);
    EXPECT_TRUE(b.stable == b.broken + 1 || 20 * b.stable <= 21 * b.broken) << edge;
  }
}

TEST(StabilityLimit, HasNoOtherSideWhereNothingOrAllBreaks) {
  const auto never = find_limit({2, 64, 512}, [](std::int64_t) { return true; });
  EXPECT_EQ(never.stable, 2);
  EXPECT_EQ(never.broken, 0);
  const auto always = find_limit({2, 64, 512}, [](std::int64_t) { return false; });
  EXPECT_EQ(always.stable, 0);
  EXPECT_EQ(always.broken, 512);
}

// A step of dt = 4 that is whole by accident, beyond steps that are not.
TEST(StabilityLimit, LongerStepsThatAreStableByAccidentDoNotCount) {
  const auto b = find_limit({2, 64, 512}, [](std::int64_t n) { return n >= 20 || n <= 4; });
  EXPECT_EQ(b.stable, 20);
}

// Up to half the largest stable dt; that itself where nothing else was run; no answer where no run is stable.
TEST(StabilityLimit, TheOrbitIsJudgedWellWithinIt) {
  finding f;
  EXPECT_FALSE(f.worst_well_within());
  f.limit.stable = 10;
  f.whole = {{10, 1e-3}};
  EXPECT_EQ(f.worst_well_within(), 1e-3);
  f.whole = {{40, 1e-15}, {20, 1e-8}, {19, 1e-4}, {10, 1e-3}};
  EXPECT_EQ(f.worst_well_within(), 1e-8);
}

}  // namespace
}  // namespace polhode
