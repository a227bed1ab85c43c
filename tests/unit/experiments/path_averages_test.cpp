// SPDX-License-Identifier: Apache-2.0
// Intervals of averages over noise paths count paths, not looks at them.
#include "experiments/attractor/path_averages.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "ensemble/noise/paths.hpp"

namespace polhode {
namespace {

constexpr int averaged_blocks = 5, looks = 3;

/// [coefficient][block, look, path]: each path shows the same at every look.
Eigen::MatrixXd looked_at_again(const Eigen::MatrixXd& once) {
  Eigen::MatrixXd out(once.rows(), looks * once.cols());
  for (int i = 0; i < averaged_blocks * looks; ++i)
    out.middleCols(i * block_lanes, block_lanes) = once.middleCols(i / looks * block_lanes, block_lanes);
  return out;
}

class Normals {
 public:
  Eigen::MatrixXd eight_of_each_path() {
    return Eigen::MatrixXd::NullaryExpr(8, averaged_blocks * block_lanes, [&] { return normal_(bits_); });
  }

 private:
  std::mt19937_64 bits_{1};
  std::normal_distribution<double> normal_;
};

TEST(PathAverages, ALookThatShowsTheSameAgainMakesNoIntervalNarrower) {
  const auto once = Normals().eight_of_each_path();
  const auto of_one = distances_of(once, 1, 0), of_all = distances_of(looked_at_again(once), looks, 0);
  for (std::size_t level = 0; level < 7; ++level) {
    SCOPED_TRACE(of_one.paths[level]);
    EXPECT_NEAR(of_all.value[level], of_one.value[level], 1e-12);
    ASSERT_TRUE(of_one.low[level] && of_all.low[level]);
    EXPECT_NEAR(*of_all.low[level], *of_one.low[level], 1e-12);
    EXPECT_NEAR(*of_all.high[level], *of_one.high[level], 1e-12);
  }
}

// E D^2 of the mean of N independent normals in eight dimensions is 8 / N.
TEST(PathAverages, IntervalsCoverTheTruth) {
  constexpr int trials = 500;
  Normals normals;
  std::array<int, 7> covered{};
  for (int trial = 0; trial < trials; ++trial) {
    const auto d = distances_of(looked_at_again(normals.eight_of_each_path()), looks, 0);
    for (std::size_t level = 0; level < 7; ++level) {
      const double truth = std::sqrt(8 / d.paths[level]);
      covered[level] += *d.low[level] <= truth && truth <= *d.high[level];
    }
  }
  for (const int count : covered) EXPECT_NEAR(count / double{trials}, 0.95, 0.035);  // 0.01 a standard error
}

}  // namespace
}  // namespace polhode
