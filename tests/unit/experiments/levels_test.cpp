// SPDX-License-Identifier: Apache-2.0
// Step sizes for orders, what is out of reach, and the one noise that all step sizes are driven by.
#include "experiments/common/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ensemble/noise/noise_defect.hpp"
#include "experiments/common/coupled_increments.hpp"
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
