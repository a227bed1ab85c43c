// SPDX-License-Identifier: Apache-2.0
// The drift of a million steps, from runs as long and from shorter ones: drifts that grow by a law known here.
#include "experiments/casimir/drift_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polhode {
namespace {

/// largest = prefactor * n^order at 1000, 2000, 4000, … steps and at the last.
drift_growth grown(double prefactor, double order, double last) {
  drift_growth d;
  const auto at = [&](double n) {
    d.steps.push_back(n);
    d.rms.push_back(prefactor * std::pow(n, order) / 2);
    d.largest.push_back(prefactor * std::pow(n, order));
  };
  for (double n = 1000; n < last; n *= 2) at(n);
  at(last);
  return d;
}

TEST(DriftGrowth, AMillionStepsAreTakenAsTheyAre) { EXPECT_DOUBLE_EQ(grown(1e-16, 0.5, 1e6).judged(), 1e-13); }

TEST(DriftGrowth, LongerRunsArePerMillionSteps) {
  EXPECT_DOUBLE_EQ(grown(1e-19, 1, 1e7).judged(), 1e-13);
  EXPECT_GT(grown(1e-16, 0.5, 1e7).judged(), 0.99e-13 / std::sqrt(10.0));  // not the last alone: the worst of all
}

TEST(DriftGrowth, ShorterRunsGrowByTheirLaw) {
  EXPECT_NEAR(grown(1e-16, 0.75, 6e4).judged(), 1e-16 * std::pow(1e6, 0.75), 1e-18);
  EXPECT_NEAR(grown(1e-16, 0.1, 6e4).judged(), 1e-16 * std::pow(6e4, 0.1) * std::sqrt(1e6 / 6e4), 1e-18);
  EXPECT_NEAR(grown(1e-25, 2, 6e4).judged(), 1e-25 * std::pow(6e4, 2) * (1e6 / 6e4), 1e-18);
}

TEST(DriftGrowth, WithoutALawItIsTakenToGrowLinearly) {
  const drift_growth once{{6e4}, {1e-14}, {3e-14}};
  EXPECT_DOUBLE_EQ(once.judged(), 3e-14 * 1e6 / 6e4);
}

// so(5) under strang_weak2: guessed 1.06e-12 from 60,000 steps, 5.3e-13 over the million.
TEST(DriftGrowth, AGuessJustBeyondTheBoundRefutesNothing) {
  const auto guess = grown(1.06e-12 / 1e6, 1, 6e4);
  ASSERT_GT(guess.judged(), rounding_bound);
  EXPECT_TRUE(guess.has_to_go_on());
}

TEST(DriftGrowth, WhatIsWithinTheBoundOrFarBeyondItEndsThere) {
  EXPECT_FALSE(grown(0.9e-12 / 1e6, 1, 6e4).has_to_go_on());
  EXPECT_FALSE(grown(11e-12 / 1e6, 1, 6e4).has_to_go_on());
  const drift_growth gone{
      {1000, 6e4}, {1e-15, std::numeric_limits<double>::infinity()}, {1e-15, std::numeric_limits<double>::infinity()}};
  EXPECT_FALSE(gone.has_to_go_on());
}

TEST(DriftGrowth, TheMillionItselfIsNoGuess) { EXPECT_FALSE(grown(2e-18, 1, 1e6).has_to_go_on()); }

}  // namespace
}  // namespace polhode
