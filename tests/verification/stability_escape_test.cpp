// SPDX-License-Identifier: Apache-2.0
// From where on a scheme that leaves the sphere runs off: by the scaling of the equation.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/common/levels.hpp"
#include "experiments/stability/stability_escape.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

stability_case case_of(const report::scene& scene) {
  stability_case c{.name = "scene", .bound = restricted(bind_scene(scene), {"euler_maruyama", "heun", "lie_euler"})};
  c.rate = fastest_rate(c.bound);
  c.horizon = 64 / c.rate;
  c.casimirs = c.casimir_sizes = {1};
  return c;
}

// The free motion is quadratic: twice the momentum at half the step is the same. Noise without a spin leaves a linear
// step, that runs off from nowhere.
TEST(Escape, ScalesAsTheEquationDoes) {
  auto scene = load_scene("paper");
  scene.number("theta") = 0;
  scene.vectors("sigma").clear();
  const auto free = case_of(scene);
  scene = load_scene("paper");
  scene.number("theta") = 0;
  scene.vector("inertia") = {1, 1, 1};
  const auto linear = case_of(scene);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& name = free.bound.schemes[k].info.name;
    const double coarse = escape_radius(free, free.bound.schemes[k], 0.1),
                 fine = escape_radius(free, free.bound.schemes[k], 0.05);
    EXPECT_GT(coarse, 2) << name;
    EXPECT_NEAR(fine / coarse, 2, 0.05) << name;
    EXPECT_TRUE(std::isinf(escape_radius(linear, linear.bound.schemes[k], 0.1))) << name;
  }
}

TEST(Escape, IsRarerAtSmallerSteps) {
  const auto in = case_of(load_scene("paper"));
  ASSERT_EQ(in.bound.schemes.size(), 3u);
  for (const auto& scheme : in.bound.schemes) {
    report::results out;
    recorder record("stability", scheme.info.name, out);
    report_escape(in, scheme, record);
    std::vector<double> share;
    for (const auto& m : out.measurements)
      if (m.quantity == "share_leaving_shell") share.push_back(*m.value);
    EXPECT_EQ(share.empty(), scheme.info.casimir.exact) << scheme.info.name;
    if (share.empty()) continue;
    EXPECT_GE(share.size(), 3u) << scheme.info.name;
    EXPECT_GT(share.front(), 0.1) << scheme.info.name;
    EXPECT_LE(share.back(), 1e-6) << scheme.info.name;
  }
}

}  // namespace
}  // namespace polhode
