// SPDX-License-Identifier: Apache-2.0
// Margins and budgets as the guides state them.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/path_limit.hpp"
#include "experiments/common/rounding_floor.hpp"
#include "statistics/box_dimension.hpp"
#include "statistics/multipliers.hpp"
#include "statistics/noise/noise_audit.hpp"
#include "statistics/orders/level_choice.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

TEST(StatedNumbers, MarginsOfClaims) {
  EXPECT_EQ(order_margin, 0.1);
  EXPECT_EQ(tight_order, 0.02);
  EXPECT_EQ(distance_share, 0.02);
  EXPECT_EQ(strength_margin, 0.01);
  EXPECT_EQ(floor_bound, 16);
}

TEST(StatedNumbers, LevelsOfAFit) {
  EXPECT_EQ(least_levels, 4u);
  EXPECT_EQ(fitted_levels, 6);
  EXPECT_EQ(response_levels, 4);
  EXPECT_EQ(off_the_line, 0.05);
  EXPECT_EQ(least_fill, 16);
  EXPECT_EQ(box_prefactor, 7);
  EXPECT_EQ(most_time_scales, 1e5);
  EXPECT_EQ(bootstrap_replicates, 400);
}

// One in ten million on both sides, one in a million over all deviations of a run.
TEST(StatedNumbers, ChancesOfAFalseAlarm) {
  EXPECT_NEAR(std::erfc(family_z / std::sqrt(2.0)), 1e-7, 2e-9);
  EXPECT_EQ(audit_false_alarm, 1e-6);
}

}  // namespace
}  // namespace polhode
