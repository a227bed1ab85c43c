// SPDX-License-Identifier: Apache-2.0
// Schemes behind faces are the schemes: what a tape does on the face of a system, with a noise of its own, a common one
// and none, is what the scheme's header does on the system's struct, for every size of step.
#include <gtest/gtest.h>

#include <polhode/systems/heavy_top.hpp>
#include <polhode/systems/so4_body.hpp>
#include <polhode/systems/spins.hpp>
#include <polhode/systems/varying_spin.hpp>

#include "ensemble/noise/paths.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

constexpr int lane = 5;

/// The scene of that name with some of its parts changed, and the same system as a struct of the installed headers,
/// with its noise and without.
template <class System>
struct case_of {
  report::scene scene;
  System system, silent;
};
template <class System>
case_of<System> with_silence(report::scene scene, System system, constant_noise<typename System::algebra> none) {
  return {std::move(scene), system, system.with_noise(std::move(none))};
}

case_of<so4_body> bodies() {
  return with_silence<so4_body>(load_scene("so4"), {{1, 2, 3, 1.25, 2.5, 1.6}, 0.3, 0.4, so4_body::isotropic(0.3)}, {});
}
case_of<heavy_top> top() {
  return with_silence<heavy_top>(load_scene("heavy_top"),
                                 {{1, 1.5, 2.2}, 0.8, {0.3, -0.4, 0.6}, 0.3, heavy_top::isotropic(0.4)}, {});
}
/// The scene's two spins have a face of six components in registers; these are those of any number.
case_of<spins> case_of_two_spins() {
  const Eigen::Matrix3d quadratic = Eigen::Vector3d(0, 0, -0.6).asDiagonal();
  return with_silence<spins>(load_scene("spin_pair"),
                             {quadratic, {0.2, 0, 0.1}, Eigen::Matrix2d::Ones(), 0.2, spins::isotropic(0.4, 6)},
                             spins::isotropic(0, 6));
}
case_of<spins> three_spins() {
  auto scene = load_scene("spin_pair");
  scene.number("count") = 3;
  const Eigen::Matrix3d exchange{{0, 0.7, -0.4}, {0.7, 0, 0.5}, {-0.4, 0.5, 0}};
  scene.vectors("exchange") = {{0, 0.7, -0.4}, {0.7, 0, 0.5}, {-0.4, 0.5, 0}};
  scene.momentum = {0.6, 0.48, 0.64, -0.3, 0.8, 0.5, 0, 0.6, -0.8};
  report::number_rows sigma(9, std::vector<double>(9, 0.0));
  for (std::size_t k = 0; k < 9; ++k) sigma[k][k] = 0.4;
  scene.vectors("sigma") = sigma;
  const Eigen::Matrix3d quadratic = Eigen::Vector3d(0, 0, -0.6).asDiagonal();
  return with_silence<spins>(scene, {quadratic, {0.2, 0, 0.1}, exchange, 0.2, spins::isotropic(0.4, 9)},
                             spins::isotropic(0, 9));
}
case_of<spin> one_spin() {
  auto scene = load_scene("spin");
  scene.vectors("quadratic") = {{1, 0.3, -0.2}, {0.3, -0.5, 0.1}, {-0.2, 0.1, 0.2}};
  scene.vector("field") = {0.3, -0.2, 0.5};
  scene.number("theta") = 0.4;
  scene.vectors("sigma") = {{0.3, 0.1, 0}, {-0.2, 0.4, 0.1}, {0, 0.3, 0.2}};
  const Eigen::Matrix3d quadratic{{1, 0.3, -0.2}, {0.3, -0.5, 0.1}, {-0.2, 0.1, 0.2}};
  const std::vector<vec<double, 3>> sigma{{{0.3, 0.1, 0}}, {{-0.2, 0.4, 0.1}}, {{0, 0.3, 0.2}}};
  return with_silence<spin>(scene, {quadratic, {0.3, -0.2, 0.5}, 0.4, spin::from_vectors(sigma)}, {});
}
case_of<varying_spin> damped_spin() {
  auto [scene, body, silent] = one_spin();
  scene.parameters.push_back({"noise", report::shape::word, {}, "field and damping"});
  return {scene, {body, state_noise::damped}, {silent, state_noise::damped}};
}

/// The increments of so many steps of one path, [step][channel] and [step][pair]: those of the first nine channels.
struct path {
  std::vector<double> dw, area;
  path(int channels, int steps, double dt) {
    constexpr int most = 9;
    for (int i = 0; i < steps; ++i) {
      const auto w = some_increment<most>(dt, static_cast<std::uint64_t>(i));
      dw.insert(dw.end(), w.dw.begin(), w.dw.begin() + channels);
      area.insert(area.end(), w.area.begin(), w.area.begin() + pairs_among(channels));
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
std::vector<double> by_the_step(const case_of<System>& c, const path* noise, int steps, double dt) {
  const auto system = prepared<Scheme>(noise != nullptr ? c.system : c.silent, dt);
  const int channels = channels_of(system), pairs = pairs_among(channels);
  auto mu = zeros<state_of<System>>(dimension_of(system));
  std::ranges::copy(c.scene.momentum, mu.begin());
  for (int i = 0; i < steps; ++i) {
    wiener_levy<double, System::channels> w;
    w.dt = dt;
    w.dw = zeros<decltype(w.dw)>(channels);
    w.area = zeros<decltype(w.area)>(pairs);
    if (noise != nullptr) {
      std::copy_n(noise->dw.begin() + i * channels, channels, w.dw.begin());
      std::copy_n(noise->area.begin() + i * pairs, pairs, w.area.begin());
    }
    mu = Scheme::step(system, mu, w);
  }
  return {mu.begin(), mu.end()};
}

void expect_near(const std::vector<double>& states, const std::vector<double>& expected, const std::string& where) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double scale = std::max(1.0, std::fabs(expected[i]));
    EXPECT_NEAR(states[i * block_lanes + lane], expected[i], 1e-12 * scale) << where << ", component " << i;
  }
}

template <class Scheme, class System>
void expect_the_paths_of(const case_of<System>& c) {
  const auto s = bind_scene(c.scene);
  const auto entry = std::ranges::find(s.schemes, Scheme::info.name, [](const auto& e) { return e.info.name; });
  if constexpr (!scheme_on<Scheme, System>) {
    EXPECT_EQ(entry, s.schemes.end()) << c.scene.name;
  } else {
    ASSERT_NE(entry, s.schemes.end()) << c.scene.name;
    EXPECT_EQ(entry->needs_areas, (needs_areas_on<Scheme, System>));
    for (const double dt : {0.004, 0.1, 0.8}) {
      if (dt > 0.1 && !Scheme::info.casimir.exact) continue;  // off the orbit rounding grows with the state
      const auto where = c.scene.name + ", dt " + std::to_string(dt);
      const int steps = dt < 0.01 ? 100 : 10;
      const auto k = entry->make(dt);
      const path w(channels_of(c.system), steps + 3, dt);  // a view may hold more than the steps that it names
      const auto start = replicated(c.scene.momentum);
      auto own = start, common = start, silent = start;
      const auto dw = in_every_lane(w.dw), area = in_every_lane(w.area);
      k->advance(own, {steps, dw, area});
      k->advance(common, k->share({steps, w.dw, w.area}), 0, steps);
      k->advance(silent, silence(steps));
      const auto expected = by_the_step<Scheme>(c, &w, steps, dt);
      expect_near(own, expected, where);
      expect_near(common, expected, where + ", common noise");
      expect_near(silent, by_the_step<Scheme>(c, nullptr, steps, dt), where + ", no noise");
    }
  }
}

template <class Scheme>
struct Faces : testing::Test {};
TYPED_TEST_SUITE(Faces, every_scheme);

TYPED_TEST(Faces, GiveThePathsOfTheScalarStepOfBodies) { expect_the_paths_of<TypeParam>(bodies()); }
TYPED_TEST(Faces, GiveThePathsOfTheScalarStepOfATop) { expect_the_paths_of<TypeParam>(top()); }
TYPED_TEST(Faces, GiveThePathsOfTheScalarStepOfTwoSpins) { expect_the_paths_of<TypeParam>(case_of_two_spins()); }
TYPED_TEST(Faces, GiveThePathsOfTheScalarStepOfThreeSpins) { expect_the_paths_of<TypeParam>(three_spins()); }
TYPED_TEST(Faces, GiveThePathsOfTheScalarStepOfASpin) { expect_the_paths_of<TypeParam>(one_spin()); }
TYPED_TEST(Faces, GiveThePathsOfTheScalarStepUnderNoiseThatDependsOnTheState) {
  expect_the_paths_of<TypeParam>(damped_spin());
}

}  // namespace
}  // namespace polhode::test
