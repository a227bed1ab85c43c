// SPDX-License-Identifier: Apache-2.0
// Intervals from replicates.
#include "statistics/resample.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace polhode {
namespace {

// Student's quantile is 2.0687 at 23 degrees, and 2 Phi(2.0687 sqrt(24 / 23)) - 1 = 0.9654.
TEST(BootstrapInterval, OfFewIsWider) {
  std::vector<double> replicates(1001);
  std::iota(replicates.begin(), replicates.end(), 0.0);
  EXPECT_EQ(bootstrap_interval(replicates, 0.95, 24), std::pair(17.0, 983.0));
  EXPECT_EQ(bootstrap_interval(replicates, 0.95, 1'000'000), std::pair(25.0, 975.0));
  EXPECT_EQ(central_interval(replicates, 0.95), std::pair(25.0, 975.0));
}

TEST(BootstrapInterval, OfOneSampleIsWhatItIs) {
  EXPECT_EQ(bootstrap_interval(std::vector(10, 3.0), 0.95, 1), std::pair(3.0, 3.0));
}

TEST(BootstrapInterval, CoversWhatItClaimsOfTwelveNumbers) {
  constexpr int trials = 4000, samples = 12, replicates = 400;
  std::mt19937_64 bits(1);
  std::normal_distribution<double> normal;
  int wide = 0, narrow = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> x(samples), means(replicates);
    for (auto& one : x) one = normal(bits);
    for (int r = 0; r < replicates; ++r)
      for (const int i : resample(static_cast<std::uint64_t>(trial), r, samples))
        means[static_cast<std::size_t>(r)] += x[static_cast<std::size_t>(i)] / samples;
    const auto covers = [](const std::pair<double, double>& i) { return i.first <= 0 && 0 <= i.second; };
    wide += covers(bootstrap_interval(means, 0.95, samples));
    narrow += covers(central_interval(means, 0.95));
  }
  // 0.95, its standard error 0.0034; without the correction 0.915 or so.
  EXPECT_NEAR(wide / double{trials}, 0.95, 0.015);
  EXPECT_LT(narrow / double{trials}, 0.93);
}

}  // namespace
}  // namespace polhode
