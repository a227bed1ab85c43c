// SPDX-License-Identifier: Apache-2.0
// The kernels of systems whose states fit into registers are the schemes: flows inlined, bound to a step and an orbit,
// and a common noise as a matrix give the paths of the scalar step, for every size of step.
#include <gtest/gtest.h>

#include <polhode/systems/spins.hpp>

#include "ensemble/noise/paths.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/heavy_top.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

constexpr int lane = 5, components = 6, pairs = 15;

so4_body bodies() { return {{1, 2, 3, 1.25, 2.5, 1.6}, 0.3, 0.4, so4_body::isotropic(0.3)}; }
heavy_top top() { return {{1, 1.5, 2.2}, 0.8, {0.3, -0.4, 0.6}, 0.3, heavy_top::isotropic(0.4)}; }
/// Those of any number, so nothing of the pair's own.
spins two_spins() {
  const Eigen::Matrix3d quadratic = Eigen::Vector3d(0, 0, -0.6).asDiagonal();
  return {quadratic, {0.2, 0, 0.1}, Eigen::Matrix2d::Ones(), 0.2, spins::isotropic(0.4, components)};
}

/// The increments of so many steps of one path, [step][channel] and [step][pair].
struct path {
  std::vector<double> dw, area;
  path(int steps, double dt) {
    for (int i = 0; i < steps; ++i) {
      const auto w = some_increment<components>(dt, static_cast<std::uint64_t>(i));
      dw.insert(dw.end(), w.dw.begin(), w.dw.end());
      area.insert(area.end(), w.area.begin(), w.area.end());
    }
  }
};

/// The same for every lane of a block.
std::vector<double> in_every_lane(const std::vector<double>& of_one) {
  std::vector<double> out;
  for (const double x : of_one) out.insert(out.end(), block_lanes, x);
  return out;
}

template <class Scheme, class System>
std::vector<double> by_the_step(const System& given, const std::vector<double>& momentum, int steps, double dt) {
  const auto system = prepared<Scheme>(given, dt);
  auto mu = zeros<vec<double, System::dimension>>(components);
  std::ranges::copy(momentum, mu.begin());
  for (int i = 0; i < steps; ++i) {
    const auto one = some_increment<components>(dt, static_cast<std::uint64_t>(i));
    wiener_levy<double, System::channels> w;
    w.dt = dt;
    w.dw = zeros<decltype(w.dw)>(components);
    w.area = zeros<decltype(w.area)>(pairs);
    std::ranges::copy(one.dw, w.dw.begin());
    std::ranges::copy(one.area, w.area.begin());
    mu = Scheme::step(system, mu, w);
  }
  return {mu.begin(), mu.end()};
}

template <class Scheme, class System>
void expect_the_paths_of(const System& system, const char* name) {
  const auto s = bind_scene(load_scene(name));
  const auto entry = std::ranges::find(s.schemes, Scheme::info.name, [](const auto& e) { return e.info.name; });
  ASSERT_NE(entry, s.schemes.end());
  for (const double dt : {0.004, 0.1, 0.8}) {
    const int steps = dt < 0.01 ? 200 : 10;
    const auto k = entry->make(dt);
    const path w(steps, dt);
    auto own = replicated(s.scene.momentum), common = own;
    const auto dw = in_every_lane(w.dw), area = in_every_lane(w.area);
    k->advance(own, {steps, dw, area});
    k->advance(common, k->share({steps, w.dw, w.area}), 0, steps);
    const auto expected = by_the_step<Scheme>(system, s.scene.momentum, steps, dt);
    for (int i = 0; i < components; ++i) {
      const double scale = std::max(1.0, std::fabs(expected[static_cast<std::size_t>(i)]));
      if (!std::isfinite(scale)) continue;  // a scheme that leaves the orbit, at a long step
      const auto at = static_cast<std::size_t>(i * block_lanes + lane);
      EXPECT_NEAR(own[at], expected[static_cast<std::size_t>(i)], 1e-12 * scale) << name << ", dt " << dt;
      EXPECT_NEAR(common[at], expected[static_cast<std::size_t>(i)], 1e-12 * scale) << name << ", common, dt " << dt;
    }
  }
}

template <class Scheme>
struct RegisterKernels : testing::Test {};
using tuned = testing::Types<heun, lie_heun, strang, strang_weak2, magnus>;
TYPED_TEST_SUITE(RegisterKernels, tuned);

TYPED_TEST(RegisterKernels, GiveThePathsOfTheScalarStep) {
  expect_the_paths_of<TypeParam>(bodies(), "so4");
  expect_the_paths_of<TypeParam>(top(), "heavy_top");
  expect_the_paths_of<TypeParam>(two_spins(), "spin_pair");
}

}  // namespace
}  // namespace polhode::test
