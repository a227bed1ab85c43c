// Random scenes against experiment `modified`: a healthy scheme is never refuted.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "registry/scene.hpp"
#include "registry/verify.hpp"

namespace polhode::test {

/// Inertia from prolate to oblate, strong and weak dissipation or none, noise of every class or none, any momentum.
inline report::scene drawn_body(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  const auto between = [&](double low, double high) { return low * std::pow(high / low, unit(random)); };
  auto scene = load_scene("paper");
  scene.name = "drawn";
  for (auto& i : scene.inertia) i = between(0.5, 4);
  if (unit(random) < 0.2) scene.inertia[1] = scene.inertia[0];
  scene.theta = unit(random) < 0.2 ? 0 : between(0.05, 2);
  const double radius = between(0.3, 3), strength = between(0.1, 1);
  Eigen::Vector3d at(normal(random), normal(random), normal(random));
  at *= radius / at.norm();
  scene.momentum = {at[0], at[1], at[2]};
  scene.sigma.clear();
  const int kind = static_cast<int>(5 * unit(random));  // none, one vector, isotropic, along the axes, any
  const int vectors = kind == 0 ? 0 : kind == 1 ? 1 : 3;
  for (int k = 0; k < vectors; ++k) {
    std::array<double, 3> v{};
    for (int i = 0; i < 3; ++i) {
      const double size = kind == 2 ? 1 : normal(random);
      v[static_cast<std::size_t>(i)] = kind == 2 || kind == 3 ? (i == k ? strength * size : 0) : strength * size;
    }
    scene.sigma.push_back(v);
  }
  return scene;
}

/// How many verdicts of `modified` hold, of one drawn scheme or of all of them; those refuted are failures.
inline int attack_modified(std::mt19937_64& random, bool all_schemes) {
  auto s = bind_scene(drawn_body(random));
  if (!all_schemes) s.schemes = {s.schemes[random() % s.schemes.size()]};
  verify_options options;
  options.experiments = {"modified"};
  options.effort = effort::quick;
  options.threads = 2;
  int holding = 0;
  for (const auto& v : verify_subject(s, options).verdicts) {
    holding += v.kind == report::verdict_kind::holds;
    EXPECT_NE(v.kind, report::verdict_kind::refuted)
        << v.scheme << ", " << v.claim << ": " << v.reason << "; inertia " << s.scene.inertia[0] << ' '
        << s.scene.inertia[1] << ' ' << s.scene.inertia[2] << ", theta " << s.scene.theta << ", "
        << s.scene.sigma.size() << " noise vectors";
  }
  return holding;
}

}  // namespace polhode::test
