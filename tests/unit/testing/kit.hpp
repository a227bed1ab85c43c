// SPDX-License-Identifier: Apache-2.0
// What tests of the kit share: rates of false alarms with their exact intervals.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "statistics/distributions.hpp"

namespace polhode::testkit_tests {

using random_bits = std::mt19937_64;
inline constexpr int healthy_sets = 10000;

/// Clopper and Pearson's interval of a rate; missed with probability 2e-6.
inline share_bounds rate(int alarms) { return binomial_bounds(healthy_sets, alarms, 1e-6); }

/// run(bits): is a healthy set refuted?
template <class Run>
int alarms(std::uint64_t seed, Run run) {
  random_bits bits(seed);
  int count = 0;
  for (int i = 0; i < healthy_sets; ++i) count += run(bits);
  return count;
}

/// Within the budget, as far as the sets can tell.
inline void expect_within(int count, double budget) {
  EXPECT_LE(rate(count).low, budget) << count << " of " << healthy_sets;
  testing::Test::RecordProperty("alarms", count);
}

/// The interval of the measured rate holds what theory gives.
inline void expect_rate(int count, double theory) {
  EXPECT_LE(rate(count).low, theory) << count << " of " << healthy_sets;
  EXPECT_GE(rate(count).high, theory) << count << " of " << healthy_sets;
  testing::Test::RecordProperty("alarms", count);
}

template <class Test, class Draw>
void fill(Test& t, Draw draw) {
  while (t.wants_more()) t.add(draw());
}

}  // namespace polhode::testkit_tests
