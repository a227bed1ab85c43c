// SPDX-License-Identifier: Apache-2.0
// Intervals from replicates.
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

// A constant stays what it is, columns stay coupled, and the mean of all is that of the sample.
TEST(ResampledMeans, AreMeansOfWholePaths) {
  values_of_paths values(8, 3);
  for (Eigen::Index p = 0; p < 8; ++p) values.row(p) << 3, static_cast<double>(p), 2.0 * static_cast<double>(p) + 1;
  const auto means = resampled_means(values, 5);
  ASSERT_EQ(means.rows(), bootstrap_replicates);
  EXPECT_LT((means.col(0).array() - 3).abs().maxCoeff(), 1e-14);
  EXPECT_LT((means.col(2) - 2 * means.col(1)).array().abs().maxCoeff() - 1, 1e-13);
  EXPECT_NEAR(means.col(1).mean(), 3.5, 5 * std::sqrt(21 / 4.0 / 8 / bootstrap_replicates));
  const double variance = (means.col(1).array() - means.col(1).mean()).square().mean();
  EXPECT_NEAR(variance, 21 / 4.0 / 8, 0.25 * 21 / 4.0 / 8);
}

// Of two Student's law of one degree is Cauchy's: t = tan(0.95 pi / 2), times the root of two.
TEST(BootstrapInterval, OfTwoIsAlmostAll) {
  std::vector<double> replicates(1001);
  std::iota(replicates.begin(), replicates.end(), 0.0);
  const double share = std::erf(std::tan(0.3 * std::acos(-1) / 2));  // sqrt(2) t / sqrt(2)
  const auto [low, high] = bootstrap_interval(replicates, 0.3, 2);
  EXPECT_EQ(low, std::round(500 * (1 - share)));
  EXPECT_EQ(high, std::round(500 * (1 + share)));
}

}  // namespace
}  // namespace polhode
