// SPDX-License-Identifier: Apache-2.0
// Verdicts on what is left of a path's error as dt -> 0, and when it is known well enough.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "experiments/common/path_limit.hpp"
#include "problem/drives.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<direction> two_directions() {
  std::vector<direction> out(2);
  out[0].name = "noise";
  out[0].channel = 0;
  out[1].name = "time";
  return out;
}

multiplier strength(double error, double half, double sure) {
  return {.known = true, .error = {error, error - half, error + half}, .sure = sure, .size = 1};
}

/// A distance of 0.01 at most under a bound of 0.02, a noise that is right to 0.002, and a time.
path_limit healthy(multiplier time = strength(0.001, 0.002, 0.01)) {
  return {{0.004, 0.001, 0.01}, 0.02, {strength(-0.001, 0.002, 0.01), time}, {0.01, 0.01}};
}

verdict_kind kind_of(const path_limit& l) { return judge_limit(l, two_directions(), 2).kind; }

TEST(PathLimit, HoldsWhereDistanceAndStrengthsDo) {
  const auto v = judge_limit(healthy(), two_directions(), 2);
  EXPECT_EQ(v.kind, verdict_kind::holds);
  EXPECT_EQ(v.estimate, 0.002);
  EXPECT_EQ(v.low, 0.0005);
  EXPECT_EQ(v.high, 0.005);
  EXPECT_EQ(v.reason,
            "distance from the solution as dt -> 0, in units of |mu_0|: at most 0.005, bound 0.01; strengths as dt -> "
            "0: noise 0.99900 [0.99700, 1.00100], time 1.00100 [0.99900, 1.00300]");
}

TEST(PathLimit, TheWorstOfThemIsTheVerdict) {
  EXPECT_EQ(kind_of(healthy(strength(0.011, 0.002, 0.01))), verdict_kind::refuted);
  EXPECT_EQ(kind_of(healthy(strength(-0.011, 0.002, 0.01))), verdict_kind::refuted);
  EXPECT_EQ(kind_of(healthy(strength(0.009, 0.002, 0.01))), verdict_kind::inconclusive);  // beyond its margin, unsurely
  EXPECT_EQ(kind_of(healthy(strength(0.0078125, 0.002, 0.0078125))), verdict_kind::holds);  // no more than is sure
  EXPECT_EQ(kind_of(healthy(strength(nan, 0, 0))), verdict_kind::inconclusive);
  auto unsure = healthy();
  unsure.distance.high = 0.03;
  EXPECT_EQ(kind_of(unsure), verdict_kind::inconclusive);
  unsure.strengths[1] = strength(0.011, 0.002, 0.01);
  EXPECT_EQ(kind_of(unsure), verdict_kind::refuted);
  auto far = healthy();
  far.distance = {0.03, 0.025, 0.04};
  EXPECT_EQ(kind_of(far), verdict_kind::refuted);
  far.strengths[0] = strength(nan, 0, 0);
  EXPECT_EQ(kind_of(far), verdict_kind::refuted);
}

// A scheme that is its twin to rounding scatters by nothing.
TEST(PathLimit, RoundingRefutesNoStrength) {
  EXPECT_EQ(kind_of(healthy(strength(0.9e-12, 0, 0))), verdict_kind::holds);
  EXPECT_EQ(kind_of(healthy(strength(1.1e-12, 0, 0))), verdict_kind::refuted);
}

TEST(PathLimit, AStrengthThatIsNotKnownSaysNothing) {
  auto unknown = strength(0.5, 0.002, 0.01);
  unknown.known = false;
  const auto v = judge_limit(healthy(unknown), two_directions(), 2);
  EXPECT_EQ(v.kind, verdict_kind::holds);
  EXPECT_EQ(v.reason.find("time"), std::string::npos);
}

TEST(PathLimit, NoUsableLevelsAreNoAnswer) {
  auto none = healthy();
  none.distance = {nan, nan, nan};
  const auto v = judge_limit(none, two_directions(), 2);
  EXPECT_EQ(v.kind, verdict_kind::inconclusive);
  EXPECT_EQ(v.reason, "no usable levels");
  EXPECT_TRUE(tight(none));
}

// A third of the bound, of either side of the interval; a third of a strength's margin.
TEST(PathLimit, IsTightByItsWidths) {
  auto limit = healthy();
  limit.distance = {0.5, 0.5 - 0.0066, 0.5 + 0.0066};
  limit.strengths[1] = strength(0.5, 0.0033, 0);
  EXPECT_TRUE(tight(limit));
  limit.strengths[1] = strength(0.5, 0.0034, 0);
  EXPECT_FALSE(tight(limit));
  limit.strengths[1].known = false;
  EXPECT_TRUE(tight(limit));
  limit.strengths[0] = strength(0, 0.0034, 0);
  EXPECT_FALSE(tight(limit));
  limit.strengths[0].known = false;
  limit.distance = {0.5, 0.5 - 0.0067, 0.5 + 0.0067};
  EXPECT_FALSE(tight(limit));
}

/// Of a scheme with these strong orders and this weak order everywhere, under three vectors on the axes.
double gap_order_of(double commuting, double general, double weak, double third_vector) {
  scheme_info info{};
  info.strong_order = {.commuting = commuting, .general = general};
  info.weak_order = {.one_vector = weak, .isotropic = weak, .general = weak};
  return gap_order(
      bind_scene(with_noise_vectors(load_scene("paper"), {{0.5, 0, 0}, {0, 0.4, 0}, {0, 0, third_vector}})), info);
}

TEST(GapOrder, IsThatOfTheNoiseThatASchemeOfWeakOrderTwoAddsWhereNoneIs) {
  EXPECT_EQ(gap_order_of(1, 0.5, 2, 0), 0.5);
  EXPECT_EQ(gap_order_of(1, 0.5, 2, 0.3), 1);
  EXPECT_EQ(gap_order_of(1, 0.5, 1, 0), 1);
  EXPECT_EQ(gap_order_of(1.5, 1, 2, 0), 1.5);
}

// Lane l: 2 + 10 l from two channels, component by component; the direction of time has no part.
TEST(NoiseEffect, IsTheSumOverTheNoise) {
  auto directions = two_directions();
  directions.push_back({"noise 2", 1, nullptr});
  std::vector<std::vector<double>> responses(3, std::vector<double>(2 * block_lanes, 0));
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    responses[0][lane] = 2;
    responses[2][lane] = 10 * static_cast<double>(lane);
    responses[2][block_lanes + lane] = -3;
    responses[1][lane] = 1e6;
  }
  noise_effect effect{std::vector<double>(2 * block_lanes, 0)};
  keep(responses, directions, block_lanes, effect);
  double sum = 0;
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    const double square = std::pow(2 + 10 * static_cast<double>(lane), 2) + 9;
    EXPECT_EQ(effect.squares[lane], 0);
    EXPECT_DOUBLE_EQ(effect.squares[block_lanes + lane], square);
    sum += square;
  }
  EXPECT_NEAR(effect.rms(2 * block_lanes), std::sqrt(sum / (2 * block_lanes)), 1e-10);
  EXPECT_EQ(effect.rms(block_lanes), 0);
  EXPECT_EQ((noise_effect{{16, 0, 0, 0}}.rms(4)), 2);
}

/// The end points of a block on five levels, and what is asked of them.
struct kept : testing::Test {
  static constexpr int levels = 5, directions = 5, first = block_lanes;
  const subject s = bind_scene(load_scene("paper"));
  const level_grid grid{0.25, {1, 2, 4, 8, 16}};
  const driven_kernels kernels = driven_kernels_of(s, grid, 2);
  const context c{.subject = s, .seed = 4};
  driven_block block{c, grid, 2, {}, kernels};
  std::vector<std::vector<double>> states, responses;

  void SetUp() override {
    block.start(0);
    block.advance(0);
    const auto numbers = [](std::size_t n) {
      std::vector<double> out;
      for (std::size_t i = 0; i < 3 * block_lanes; ++i) out.push_back(std::sin(static_cast<double>(7 * n + i)));
      return out;
    };
    for (std::size_t l = 0; l < levels; ++l) states.push_back(numbers(l));
    for (std::size_t k = 0; k < directions; ++k) responses.push_back(numbers(100 + k));
  }

  static double at(const std::vector<double>& block, int lane, std::size_t i) {
    return block[i * block_lanes + static_cast<std::size_t>(lane)];
  }
};

TEST_F(kept, AreTheProductsOfErrorsGapsAndResponses) {
  for (const bool with_areas : {false, true}) {
    path_record record(2 * block_lanes, levels, directions);
    ASSERT_EQ(record.response.levels, response_levels);
    keep(states, block, responses, with_areas, first, record);
    for (const int lane : {0, 1, 63})
      for (int l = 0; l < levels; ++l) {
        double error = 0, gap = 0, product = 0, square = 0;
        std::vector<double> answer(directions);
        for (std::size_t i = 0; i < 3; ++i) {
          const auto level = static_cast<std::size_t>(l);
          const double x = at(states[level], lane, i), truth = at(block.truth(), lane, i),
                       twin = at(block.twin(level), lane, i), apart = x - (with_areas ? truth : twin);
          error += (x - truth) * (x - truth);
          gap += apart * apart;
          product += (x - truth) * (truth - twin);
          square += (truth - twin) * (truth - twin);
          for (std::size_t k = 0; k < directions; ++k) answer[k] += apart * at(responses[k], lane, i);
        }
        const int path = first + lane;
        EXPECT_NEAR(record.error.at(path, l), error, 1e-14);
        EXPECT_NEAR(record.gap.at(path, l), gap, 1e-14);
        EXPECT_NEAR(record.areas.product.at(path, l), product, 1e-14);
        EXPECT_NEAR(record.areas.square.at(path, l), square, 1e-14);
        EXPECT_NE(record.areas.square.at(path, l), 0);
        for (int k = 0; l > 0 && k < directions; ++k)  // of the finest four
          EXPECT_NEAR(record.response.response_of(path, l - 1)[k], answer[static_cast<std::size_t>(k)], 1e-14);
      }
    for (const int lane : {0, 1, 63})
      for (std::size_t j = 0; j < directions; ++j)
        for (std::size_t k = 0; k < directions; ++k) {
          double product = 0;
          for (std::size_t i = 0; i < 3; ++i) product += at(responses[j], lane, i) * at(responses[k], lane, i);
          EXPECT_NEAR(record.response.gram_of(first + lane)[j * directions + k], product, 1e-14);
        }
  }
}

// Of few levels, all.
TEST_F(kept, OfThreeLevelsAllHaveTheirResponse) {
  EXPECT_EQ(path_record(4, 3, 2).response.levels, 3);
  EXPECT_EQ(path_record(4, 3, 2).response.response.size(), 4u * 3 * 2);
}

// The distance by the error model of the gap's order, its bound by the noise's effect, margins by what a direction
// does.
TEST_F(kept, LimitIsThatOfItsGapAndItsResponses) {
  path_record record(block_lanes, levels, directions);
  keep(states, block, responses, false, 0, record);
  for (int path = 0; path < block_lanes; ++path)
    for (int l = 0; l < levels; ++l)
      record.gap.at(path, l) = (0.04 + std::pow(grid.dt()[std::size_t(l)], 2)) * (1 + path % 3);
  for (double& x : record.response.gram) x *= 0.01;
  const noise_effect effect{std::vector<double>(block_lanes, 0.25)};
  ASSERT_DOUBLE_EQ(effect.rms(block_lanes), 0.5);
  const auto dt = grid.dt();
  for (const double order : {0.5, 1.0}) {
    scheme_info info{};
    info.strong_order = {.commuting = order, .general = order};
    const auto limit = limit_of(c, info, dt, record, effect, 2);
    EXPECT_DOUBLE_EQ(limit.bound, (order < 1 ? 0.02 : 0.002) * 0.5);
    const auto fit = fit_order(dt, record.gap, 0, 4);
    EXPECT_DOUBLE_EQ(limit.distance.value, fit_error_model(dt, record.gap, fit->used, order, 4).limit.value);
    ASSERT_EQ(limit.strengths.size(), 5u);
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_DOUBLE_EQ(limit.margins[k], 0.01 * std::max(1.0, 0.5 / limit.strengths[k].size));
    EXPECT_GT(limit.margins[0], 0.011);
    const noise_effect slight{std::vector<double>(block_lanes, 1e-4)};  // below that of any direction
    EXPECT_DOUBLE_EQ(limit_of(c, info, dt, record, slight, 2).margins[0], 0.01);
  }
}

}  // namespace
}  // namespace polhode
