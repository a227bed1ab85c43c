// SPDX-License-Identifier: Apache-2.0
#include "ensemble/noise/paths.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include <polhode/integrate.hpp>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/schemes.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

TEST(ParallelFor, DoesEveryPieceOnce) {
  for (const int threads : {1, 2, 3, 50}) {
    std::vector<std::atomic<int>> done(200);
    parallel_for(threads, 200, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
    for (const auto& d : done) EXPECT_EQ(d, 1);
  }
  parallel_for(2, 0, [](int) { FAIL() << "nothing to do"; });
}

TEST(ParallelFor, PassesTheFirstExceptionOn) {
  EXPECT_THROW(parallel_for(3, 100,
                            [](int i) {
                              if (i == 7) throw std::runtime_error("seven");
                            }),
               std::runtime_error);
}

// The laboratory's blocks and an outside user's loop see the same noise and take the same steps.
TEST(Ensemble, IsTheLoopOfTheLibrary) {
  const auto s = bind_scene(load_scene("paper"));
  constexpr int steps = 100;
  constexpr double dt = 0.02;
  increment_buffer noise(*s.model, steps, false);
  auto states = replicated(s.scene.momentum);
  test::scheme_of(s, strang::info.name).make(dt)->advance(states, noise.fill(5, 32, 0, steps, dt));
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto alone = integrate<strang>(test::paper_body(), test::paper_momentum, dt, steps,
                                         {.seed = 5, .path = static_cast<std::uint64_t>(32 + lane)});
    const auto here = lane_of(states, lane, 3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(here[static_cast<std::size_t>(k)], alone[k], 1e-13);
  }
}

// One channel in use draws no more than one, and a scene without noise draws nothing; the numbers stay the same.
TEST(Increments, UnusedChannelsAreZero) {
  auto scene = load_scene("single");
  const auto one = bind_scene(scene);
  EXPECT_EQ(one.model->layout().active, 1);
  increment_buffer noise(*one.model, 1, true);
  const auto view = noise.fill(1, 0, 0, 1, 1.0);
  EXPECT_EQ(view.dw[0], normals<1>({1, noise_kind::increment, 0, 0})[0]);
  for (int k = block_lanes; k < 3 * block_lanes; ++k) EXPECT_EQ(view.dw[static_cast<std::size_t>(k)], 0.0);
  ASSERT_EQ(view.area.size(), 3u * block_lanes);
  for (const double area : view.area) EXPECT_EQ(area, 0.0);
  scene.vectors("sigma").clear();
  EXPECT_EQ(bind_scene(scene).model->layout().active, 0);
}

// Three channels, areas, two lanes.
TEST(Increments, APartHasItsStepsAlone) {
  std::vector<double> dw(5 * 6), area(5 * 6);
  for (std::size_t i = 0; i < dw.size(); ++i) area[i] = -(dw[i] = static_cast<double>(i));
  const std::vector<float> singles(dw.begin(), dw.end());
  const auto numbers = [](const auto& all) { return std::vector<double>(all.begin(), all.end()); };
  const increment_view doubles{5, dw, area}, floats{5, {}, {}, singles, 0.5};
  const std::vector<double> wanted(dw.begin() + 12, dw.begin() + 24);
  EXPECT_EQ(doubles.part(2, 2).steps, 2);
  EXPECT_EQ(numbers(doubles.part(2, 2).dw), wanted);
  EXPECT_EQ(doubles.part(2, 2).area[0], -12);
  EXPECT_EQ(numbers(floats.part(2, 2).singles), wanted);
  EXPECT_EQ(floats.part(2, 2).scale, 0.5);
  EXPECT_TRUE(silence(5).part(2, 2).silent());
}

}  // namespace
}  // namespace polhode
