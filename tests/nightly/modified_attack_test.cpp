// SPDX-License-Identifier: Apache-2.0
// Random scenes, every scheme: no healthy scheme is refuted by `modified`.
// POLHODE_SCENES and POLHODE_ATTACK_SEED change how many and which.
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/from_environment.hpp"
#include "support/verdicts.hpp"

namespace polhode::test {
namespace {

/// Inertia from prolate to oblate, strong and weak dissipation or none, noise of every class or none, any momentum.
report::scene drawn_body(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  const auto between = [&](double low, double high) { return low * std::pow(high / low, unit(random)); };
  auto scene = load_scene("paper");
  scene.name = "drawn";
  for (auto& i : scene.vector("inertia")) i = between(0.5, 4);
  if (unit(random) < 0.2) scene.vector("inertia")[1] = scene.vector("inertia")[0];
  scene.number("theta") = unit(random) < 0.2 ? 0 : between(0.05, 2);
  const double radius = between(0.3, 3), strength = between(0.1, 1);
  Eigen::Vector3d at(normal(random), normal(random), normal(random));
  at *= radius / at.norm();
  scene.momentum = {at[0], at[1], at[2]};
  scene.vectors("sigma").clear();
  const int kind = static_cast<int>(5 * unit(random));  // none, one vector, isotropic, along the axes, any
  const int vectors = kind == 0 ? 0 : kind == 1 ? 1 : 3;
  for (int k = 0; k < vectors; ++k) {
    std::vector<double> v(3);
    for (int i = 0; i < 3; ++i) {
      const double size = kind == 2 ? 1 : normal(random);
      v[static_cast<std::size_t>(i)] = kind == 2 || kind == 3 ? (i == k ? strength * size : 0) : strength * size;
    }
    scene.vectors("sigma").push_back(v);
  }
  return scene;
}

/// All of it, to be drawn again.
std::string words(const report::scene& scene) {
  std::string text =
      fmt::format("inertia = [{:.17g}]\ntheta = {:.17g}\nmomentum = [{:.17g}]\nsigma = [",
                  fmt::join(scene.vector("inertia"), ", "), scene.number("theta"), fmt::join(scene.momentum, ", "));
  for (const auto& v : scene.vectors("sigma")) text += fmt::format("[{:.17g}], ", fmt::join(v, ", "));
  return text + "]";
}

struct modified_count {
  int holding = 0, inconclusive = 0, refuted = 0;
};

/// Verdicts of `modified` on one drawn scene, of every scheme; those refuted are failures.
void attack_modified(std::mt19937_64& random, modified_count& count) {
  const auto s = bind_scene(drawn_body(random));
  const auto r = quick_results(s, {"modified"});
  EXPECT_FALSE(r.verdicts.empty()) << words(s.scene);
  for (const auto& v : r.verdicts) {
    count.holding += v.kind == report::verdict_kind::holds;
    count.inconclusive += v.kind == report::verdict_kind::inconclusive;
    count.refuted += v.kind == report::verdict_kind::refuted;
    EXPECT_NE(v.kind, report::verdict_kind::refuted)
        << v.scheme << ", " << v.claim << ": " << v.reason << "; " << words(s.scene);
  }
}

TEST(ModifiedUnderAttack, RefutesNoHealthyScheme) {
  std::mt19937_64 random(static_cast<unsigned>(from_environment("POLHODE_ATTACK_SEED", 20261123)));
  const int scenes = from_environment("POLHODE_SCENES", 40);
  modified_count count;
  for (int n = 0; n < scenes; ++n) attack_modified(random, count);
  fmt::print("{} scenes: {} verdicts hold, {} are inconclusive, {} refuted\n", scenes, count.holding,
             count.inconclusive, count.refuted);
  EXPECT_GT(count.holding, 20 * scenes);
}

}  // namespace
}  // namespace polhode::test
