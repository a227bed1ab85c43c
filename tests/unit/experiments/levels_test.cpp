// SPDX-License-Identifier: Apache-2.0
// Step sizes for orders, what is out of reach, and the one noise that all step sizes are driven by.
#include "experiments/common/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "ensemble/noise/noise_defect.hpp"
#include "experiments/common/coupled_increments.hpp"
#include "problem/vectors.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

subject paper_until(double horizon) {
  auto scene = load_scene("paper");
  scene.horizon = horizon;
  return bind_scene(scene);
}

TEST(Levels, WhatRunsOverTooManyTimeScalesIsOutOfReach) {
  const double reach = most_time_scales / fastest_rate(paper_until(1));
  EXPECT_FALSE(beyond_reach(paper_until(0.999 * reach)));
  EXPECT_TRUE(beyond_reach(paper_until(1.001 * reach)));
  EXPECT_NEAR(scene_levels(paper_until(7 * reach)).horizon, reach, 1e-12 * reach);
  EXPECT_EQ(scene_levels(paper_until(2)).horizon, 2);
}

TEST(Levels, HalveOnUntilTheStepIsShort) {
  const auto s = paper_until(2);
  for (const double resolution : {16.0, 64.0}) {
    const auto grid = asymptotic_levels(s, resolution);
    const double finest = grid.dt().back() * fastest_rate(s);
    EXPECT_LE(finest, 1 / resolution);
    EXPECT_GE(grid.steps.size(), 6u);
    for (std::size_t l = 1; l < grid.steps.size(); ++l) EXPECT_EQ(grid.steps[l], 2 * grid.steps[l - 1]);
  }
  EXPECT_LE(scene_levels(s).dt().back() * fastest_rate(s), 1 / 64.0);
}

/// A scene of these steps whose fastest rate is known.
subject of_rate(double rate, double horizon, std::vector<std::int64_t> steps) {
  auto s = paper_until(horizon);
  s.scene.steps = std::move(steps);
  auto offers = *s.offers;
  offers.rates = {.motion = rate / 2, .dissipation = rate / 4, .noise = rate / 4};
  s.offers = std::make_shared<const capabilities>(offers);
  return s;
}

TEST(FinestStep, IsAQuarterOfTheFastestTimeScaleOrTheScenesOwn) {
  EXPECT_DOUBLE_EQ(finest_step(of_rate(8, 2, {4, 64})), 1 / 32.0);
  EXPECT_DOUBLE_EQ(finest_step(of_rate(8, 2, {4, 256})), 1 / 128.0);
  EXPECT_DOUBLE_EQ(finest_step(of_rate(0.5, 100, {4, 8})), 0.5);
  EXPECT_DOUBLE_EQ(finest_step(of_rate(0, 100, {4, 8})), 12.5);
  EXPECT_DOUBLE_EQ(longest_at_equilibrium(of_rate(8, 2, {4})), 0.5);
}

// needed = resolution rate horizon steps at least; the scene's coarsest step where six levels fit between both.
TEST(AsymptoticLevels, BeginAtTheScenesCoarsestStepWhereSixFit) {
  const auto levels = [](double rate, double horizon, std::int64_t coarsest, double resolution = 64) {
    return asymptotic_levels(of_rate(rate, horizon, {coarsest, 1024}), resolution);
  };
  using steps = std::vector<int>;
  EXPECT_DOUBLE_EQ(levels(3, 2, 4).horizon, 4.0 / 3);
  EXPECT_EQ(levels(3, 2, 4).steps, (steps{3, 6, 12, 24, 48, 96, 192, 384}));        // 4 of 4/3 in 2: 2.7
  EXPECT_EQ(levels(1, 4, 8).steps, (steps{8, 16, 32, 64, 128, 256}));               // just fit
  EXPECT_EQ(levels(1, 20, 37, 59.2).steps, (steps{7, 14, 28, 56, 112, 224, 448}));  // 7.4 of 7.4 that are needed
  EXPECT_EQ(levels(3, 2, 100).steps, (steps{8, 16, 32, 64, 128, 256}));             // do not
  EXPECT_EQ(levels(1, 100, 1).steps, (steps{1, 2, 4, 8, 16, 32, 64, 128, 256}));
  EXPECT_EQ(levels(1, 0.5, 1, 4).steps, (steps{1, 2, 4, 8, 16, 32}));
  EXPECT_EQ(levels(1, 0.5, 1, 4).horizon, 0.5);
  EXPECT_EQ(levels(0, 7, 4).steps, (steps{1, 2, 4, 8, 16, 32}));
  EXPECT_EQ(levels(0, 7, 4).horizon, 7);
  EXPECT_EQ(levels(0.5, 100, 4).horizon, 8);
}

TEST(SceneLevels, AreTheScenesAndThoseThatAreMissing) {
  const auto levels = [](double rate, std::vector<std::int64_t> own) {
    return scene_levels(of_rate(rate, 1, own)).steps;
  };
  using steps = std::vector<int>;
  EXPECT_EQ(levels(1, {8}), (steps{1, 2, 4, 8, 16, 32, 64}));
  EXPECT_EQ(levels(2, {8}), (steps{2, 4, 8, 16, 32, 64, 128}));  // four steps are two a time scale
  EXPECT_EQ(levels(2.1, {8}), (steps{4, 8, 16, 32, 64, 128, 256}));
  EXPECT_EQ(levels(1, {3, 5}), (steps{3, 5, 10, 20, 40, 80}));
  EXPECT_EQ(levels(0, {6}), (steps{3, 6, 12, 24, 48}));
  EXPECT_EQ(levels(1, {4, 5, 6, 7, 64}), (steps{4, 5, 6, 7, 64}));
  EXPECT_EQ(levels(1, {4, 5, 6, 7, 63}), (steps{4, 5, 6, 7, 63, 126}));
}

// |h|, but where that is next to nothing beside |mu| times the rate of the motion.
TEST(EnergySize, IsThatOfTheMotionWhereTheEnergyVanishes) {
  auto s = of_rate(1, 1, {8});
  const double own = std::fabs(s.model->energy(s.scene.momentum)), momentum = length(s.scene.momentum);
  const auto with_motion = [&](double motion) {
    auto offers = *s.offers;
    offers.rates.motion = motion;
    s.offers = std::make_shared<const capabilities>(offers);
    return energy_size(s);
  };
  EXPECT_DOUBLE_EQ(with_motion(99.95 * own / momentum), own);
  EXPECT_DOUBLE_EQ(with_motion(100.05 * own / momentum), 100.05 * own);
  s.scene.momentum = {0, 0, 0};
  EXPECT_EQ(with_motion(1), 1e-300);
}

/// What a defect is told of the coarsened increments.
struct listener : noise_defect {
  mutable std::vector<std::pair<std::uint64_t, int>> heard;  ///< first step and steps
  void spoil(const drawn_noise& n) const override {
    if (n.coarsened) heard.emplace_back(n.first_step, n.steps);
  }
};

// Two steps on the coarsest of three levels are four and eight on the others, and 24 fine ones of three cells each.
TEST(CoupledIncrements, AreOneNoiseOnAllLevels) {
  const auto s = paper_until(2);
  const level_grid grid{1, {2, 4, 8}};
  constexpr int cells = 3, fine_steps = 12;
  coupled_increments coupled(*s.model, grid, cells, {});
  increment_buffer fine(*s.model, fine_steps, false);
  const listener defect;
  const planted_noise_defect planted(defect);
  const auto rows = static_cast<std::size_t>(s.model->layout().channels) * block_lanes;
  for (int chunk = 0; chunk < 2; ++chunk) {
    defect.heard.clear();
    const auto given = coupled.fill(5, 64, chunk);
    const auto expected = fine.fill(5, 64, static_cast<std::uint64_t>(chunk * fine_steps), fine_steps, 1.0 / 24);
    ASSERT_EQ(given.steps, fine_steps);
    for (std::size_t i = 0; i < expected.dw.size(); ++i) ASSERT_EQ(given.dw[i], expected.dw[i]);
    for (std::size_t l = 0; l < 3; ++l) {
      const auto& level = coupled.level(l);
      ASSERT_EQ(level.steps, 1 << l);
      const int each = fine_steps / level.steps;
      for (int step = 0; step < level.steps; ++step)
        for (std::size_t at = 0; at < rows; ++at) {
          double sum = 0;
          for (int k = 0; k < each; ++k) sum += expected.dw[static_cast<std::size_t>(step * each + k) * rows + at];
          EXPECT_NEAR(level.dw[static_cast<std::size_t>(step) * rows + at], sum, 1e-15);
        }
      EXPECT_EQ(defect.heard[l], std::pair(static_cast<std::uint64_t>(chunk << l), 1 << l));
    }
  }
}

}  // namespace
}  // namespace polhode
