// SPDX-License-Identifier: Apache-2.0
// What experiment attractor rests on: the noise of a step before time 0 is the same for every start, and each path has
// its own; the means of the harmonics are right.
#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/simulation.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor/harmonic_moments.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

subject paper() { return bind_scene(load_scene("paper")); }

TEST(SharedIncrements, OfAPathAreThoseOfItsLane) {
  const auto s = paper();
  const shared_increments one(*s.model, 7, 20, 0.1, true, 1, {}, 67);
  increment_buffer buffer(*s.model, 20, true);
  const auto block = buffer.fill(7, 64, 0, 20, 0.1);
  const auto view = one.view(0, 20);
  ASSERT_EQ(view.dw.size(), 3u * 20u);
  ASSERT_EQ(view.area.size(), 3u * 20u);
  for (std::size_t i = 0; i < view.dw.size(); ++i) EXPECT_DOUBLE_EQ(view.dw[i], block.dw[i * block_lanes + 3]);
  for (std::size_t i = 0; i < view.area.size(); ++i) EXPECT_DOUBLE_EQ(view.area[i], block.area[i * block_lanes + 3]);
}

TEST(SharedIncrements, OfABlockAreThoseOfEachPath) {
  const auto s = paper();
  const auto numbers = [](std::span<const double> all) { return std::vector(all.begin(), all.end()); };
  for (const auto quality : {noise_quality::precise, noise_quality::fast}) {
    const noise_source source{noise_generator::philox, quality};
    const auto block = shared_increments::of_block(*s.model, 7, 70, 0.1, true, source, 64);
    ASSERT_EQ(block.size(), std::size_t{block_lanes});
    for (const std::size_t lane : {0u, 3u, 63u}) {
      const shared_increments one(*s.model, 7, 70, 0.1, true, 1, source, 64 + lane);
      const auto expected = one.view(0, 70), found = block[lane].view(0, 70);
      EXPECT_EQ(numbers(found.dw), numbers(expected.dw));
      EXPECT_EQ(numbers(found.area), numbers(expected.area));
    }
  }
}

TEST(SharedIncrements, SideBySideEachDrivesItsOwnLanes) {
  const auto s = paper();
  const auto paths = shared_increments::of_block(*s.model, 7, 20, 0.1, true, {}, 0);
  increments_side_by_side four{std::span(paths).subspan(8, 4)};
  const auto view = four.view(5, 10);
  ASSERT_EQ(view.steps, 10);
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    const auto own = paths[8 + lane / 16].view(5, 10);
    for (std::size_t i = 0; i < own.dw.size(); ++i) ASSERT_EQ(view.dw[i * block_lanes + lane], own.dw[i]);
    for (std::size_t i = 0; i < own.area.size(); ++i) ASSERT_EQ(view.area[i * block_lanes + lane], own.area[i]);
  }
}

/// Bodies that start later, with the last steps of the same table, go as bodies whose noise is those steps alone.
TEST(Pullback, AShorterRunSeesTheLastStepsOfALongerOne) {
  const auto s = paper();
  const shared_increments drawn(*s.model, 3, 100, 0.1, true, 1, {}, 5);
  ASSERT_FALSE(s.schemes.empty());
  for (const auto& scheme : s.schemes) {
    const auto stepper = scheme.make(0.1);
    const auto table = stepper->share(drawn.view(0, 100));
    std::vector<double> late(3 * block_lanes), alone;
    start_uniformly(3, 0, 1, late);
    alone = late;
    stepper->advance(late, table, 70, 30);
    stepper->advance(alone, stepper->share(drawn.view(70, 30)), 0, 30);
    for (std::size_t i = 0; i < late.size(); ++i) ASSERT_EQ(late[i], alone[i]) << scheme.info.name;
  }
}

TEST(HarmonicMeans, AreTheHarmonicsOfTheBodies) {
  std::vector<double> states(3 * block_lanes);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(24);
  harmonic_moments means(4);
  for (int block = 0; block < 3; ++block) {
    start_uniformly(1, static_cast<std::uint64_t>(block * block_lanes), 2.5, states);
    means.add(states);
    for (int lane = 0; lane < block_lanes; ++lane) {
      const auto x = lane_of(states, lane, 3);
      EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 2.5, 1e-14);
      expected += harmonics_at(Eigen::Vector3d(x.data()) / 2.5, 4).tail(24);
    }
  }
  const Eigen::VectorXd found = means.take();
  EXPECT_LT((found - std::sqrt(4 * M_PI) / (3 * block_lanes) * expected).norm(), 1e-13);
  EXPECT_LT(found.norm(), 5 / std::sqrt(3.0 * block_lanes / 24));  // uniform bodies: about sqrt(24 / bodies)
}

TEST(Simulation, EachPathHasItsOwnNoise) {
  const auto s = paper();
  simulation_plan p;
  p.noise = ensemble_noise::common;
  p.start = ensemble_start::uniform;
  p.momentum = s.scene.momentum;
  p.steps = 10;
  p.bodies = 100;
  const auto run = [&](std::uint64_t path) {
    p.path = path;
    return simulate_ensemble(*s.model, *s.schemes.front().make(0.1), p).states;
  };
  EXPECT_EQ(run(0), run(0));
  EXPECT_NE(run(0), run(1));
}

}  // namespace
}  // namespace polhode
