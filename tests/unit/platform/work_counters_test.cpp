// SPDX-License-Identifier: Apache-2.0
// What a scene does not need is not computed: shown by what was counted.
#include "platform/work_counters.hpp"

#include <gtest/gtest.h>

#include "ensemble/simulation.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

struct counted {
  work_counters work;
  simulated result;
};

counted run(const subject& s, std::string_view scheme, ensemble_noise noise, int threads = 2) {
  simulation_plan p;
  p.noise = noise;
  p.momentum = s.scene.momentum;
  p.steps = 100;
  p.bodies = 1000;  // 16 blocks
  p.threads = threads;
  const auto entry = std::ranges::find(s.schemes, scheme, [](const auto& e) { return e.info.name; });
  p.with_areas = entry->needs_areas;
  const auto before = work_so_far();
  auto result = simulate_ensemble(*s.model, *entry->make(0.01), p);
  const auto after = work_so_far();
  return {{after.normals - before.normals, after.path_steps - before.path_steps, after.kernels - before.kernels},
          std::move(result)};
}

subject paper_with(report::number_rows sigma) {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = std::move(sigma);
  return bind_scene(scene);
}

TEST(Work, NoNoiseTouchesNoGenerator) {
  const auto still = run(paper_with({}), "strang", ensemble_noise::independent);
  EXPECT_EQ(still.work.normals, 0u);
  EXPECT_EQ(still.result.drawn, 0u);
  EXPECT_EQ(still.work.path_steps, 1024u * 100);
  EXPECT_EQ(still.work.kernels, 16u) << "one call a block: nothing to refill";
}

TEST(Work, ACommonNoiseIsDrawnOnceAStepNotOnceABody) {
  EXPECT_EQ(run(paper_with({{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}), "strang", ensemble_noise::common).work.normals,
            300u);
}

TEST(Work, OnlyChannelsInUseAreDrawn) {
  EXPECT_EQ(run(paper_with({{0.5, 0, 0}}), "strang", ensemble_noise::independent).work.normals, 1024u * 100);
  EXPECT_EQ(run(bind_scene(load_scene("paper")), "strang", ensemble_noise::independent).work.normals, 3u * 1024 * 100);
}

TEST(Work, AreasAreDrawnForThoseWhoAsk) {
  const auto s = bind_scene(load_scene("paper"));
  EXPECT_EQ(run(s, "lie_heun", ensemble_noise::independent).work.normals, 3u * 1024 * 100);
  EXPECT_EQ(run(s, "magnus", ensemble_noise::independent).work.normals, 6u * 1024 * 100);
}

TEST(Work, DoesNotDependOnThreads) {
  const auto s = bind_scene(load_scene("paper"));
  const auto one = run(s, "heun", ensemble_noise::independent, 1),
             three = run(s, "heun", ensemble_noise::independent, 3);
  EXPECT_EQ(one.work.normals, three.work.normals);
  EXPECT_EQ(one.work.kernels, three.work.kernels);
  EXPECT_EQ(one.result.states, three.result.states);
}

}  // namespace
}  // namespace polhode
