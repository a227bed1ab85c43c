// SPDX-License-Identifier: Apache-2.0
// The nodes of one step's noise have its moments, also where of three areas not every product of nodes is taken.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "transfer/points/noise_nodes.hpp"

namespace polhode {
namespace {

constexpr double dt = 0.04;

/// Increments and areas of three channels, in units of their own deviations.
struct sum_over_nodes {
  noise_nodes nodes;

  double increment(std::size_t node, std::size_t k) const { return nodes.dw[3 * node + k] / std::sqrt(dt); }
  double area(std::size_t node, std::size_t k) const { return nodes.area[3 * node + k] / (dt / 2); }

  /// The mean of the product of those areas.
  double of_areas(const std::vector<std::size_t>& which) const {
    double sum = 0;
    for (std::size_t i = 0; i < nodes.weight.size(); ++i) {
      double product = nodes.weight[i];
      for (const auto k : which) product *= area(i, k);
      sum += product;
    }
    return sum;
  }
};

sum_over_nodes by(const noise_rule& rule) {
  const auto s = bind_scene(load_scene("paper"));
  return {nodes_of(*s.model, true, dt, rule)};
}

void expect_two_moments(const sum_over_nodes& sum) {
  EXPECT_NEAR(sum.of_areas({}), 1, 1e-13);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(sum.of_areas({i}), 0, 1e-13);
    for (std::size_t j = i; j < 3; ++j) EXPECT_NEAR(sum.of_areas({i, j}), i == j, 1e-13);
  }
}

TEST(NoiseNodes, HaveTheMomentsOfTheirNoise) {
  for (const int area : {2, 3, 4}) {
    const auto sum = by({5, area});
    expect_two_moments(sum);
    double eighth = 0;
    for (std::size_t i = 0; i < sum.nodes.weight.size(); ++i)
      eighth += sum.nodes.weight[i] * std::pow(sum.increment(i, 1), 8);
    EXPECT_NEAR(eighth, 105, 1e-10) << area;
  }
}

// Whatever the increment, and of the product of all three it is its neighbours that make up for it.
TEST(NoiseNodes, TwoOfThreeAreasAreIndependentGivenTheIncrement) {
  const auto sum = by({4, 2});
  EXPECT_EQ(sum.nodes.weight.size(), 4u * 4 * 4 * 4);
  std::map<std::array<double, 3>, double> product;
  for (std::size_t i = 0; i < sum.nodes.weight.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      product[{sum.increment(i, 0), sum.increment(i, 1), sum.increment(i, 2)}] +=
          sum.area(i, k) * sum.area(i, (k + 1) % 3);
  for (const auto& [at, value] : product) EXPECT_NEAR(value, 0, 1e-13);
  EXPECT_NEAR(sum.of_areas({0, 1, 2}), 0, 1e-13);
}

TEST(NoiseNodes, ThreeOfEachAreaAreExactToDegreeFive) {
  const auto sum = by({4, 3});
  EXPECT_EQ(sum.nodes.weight.size(), 4u * 4 * 4 * 14);
  EXPECT_NEAR(sum.of_areas({0, 0, 0, 0}), 3, 1e-12);
  EXPECT_NEAR(sum.of_areas({0, 0, 1, 1}), 1, 1e-12);
  for (const auto& odd : std::vector<std::vector<std::size_t>>{{0, 1, 2}, {0, 0, 1}, {0, 0, 0, 1}, {0, 0, 1, 2}})
    EXPECT_NEAR(sum.of_areas(odd), 0, 1e-12);
}

TEST(NoiseNodes, FarOnesHaveTwoMomentsOfAreas) {
  const auto s = bind_scene(load_scene("paper"));
  expect_two_moments({far_nodes_of(*s.model, true, dt)});
}

}  // namespace
}  // namespace polhode
