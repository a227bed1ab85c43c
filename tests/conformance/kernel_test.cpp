// SPDX-License-Identifier: Apache-2.0
// The laboratory's kernels are the schemes: whatever is specialised, merged, shared or approximated in them, their
// paths are those of the scalar step.
#include <gtest/gtest.h>

#include "ensemble/kernel_of.hpp"
#include "ensemble/plain_forms.hpp"
#include "platform/isa.hpp"
#include "run/verify.hpp"
#include "support/kernel_checks.hpp"

namespace polhode::test {
namespace {

template <class Scheme>
std::unique_ptr<kernel> kernel_on(const report::scene& scene, double dt) {
  for (const auto& entry : bind_scene(scene).schemes)
    if (entry.info.name == Scheme::info.name) return entry.make(dt);
  return nullptr;
}

template <class Scheme>
struct Kernel : testing::Test {
  void TearDown() override { choose_isa(usable_isas().back()); }
};
TYPED_TEST_SUITE(Kernel, every_scheme);

TYPED_TEST(Kernel, AgreesWithTheScalarStepOverAThousandSteps) {
  constexpr int steps = 1000;
  constexpr double dt = 0.004;
  for (const isa level : usable_isas()) {
    choose_isa(level);
    for (const auto& scene : every_part()) {
      const auto s = bind_scene(scene);
      const increments w(*s.model, steps, dt);
      auto states = replicated(scene.momentum);
      kernel_on<TypeParam>(scene, dt)->advance(states, w.view);
      const auto system = prepared<TypeParam>(make_rigid_body(scene), dt);
      for (const int lane : {0, 17, block_lanes - 1}) {
        auto mu = paper_momentum;
        for (int i = 0; i < steps; ++i) mu = TypeParam::step(system, mu, w.at(i, lane));
        EXPECT_LE(distance(mu, state_at(states, lane)), 1e-13)
            << TypeParam::info.name << " on " << name_of(level) << ", inertia " << scene.vector("inertia")[0]
            << scene.vector("inertia")[1] << scene.vector("inertia")[2] << ", theta " << scene.number("theta") << ", "
            << scene.vectors("sigma").size() << " vectors";
      }
    }
  }
}

// From 1e-6 to 10 rad a step: polynomials of every degree, lanes beyond their reach, closed forms.
TYPED_TEST(Kernel, AgreesWithTheScalarStepForRotationsOfAnySize) {
  constexpr int steps = 20;
  int tried = 0, compared = 0;
  for (const isa level : usable_isas()) {
    choose_isa(level);
    for (const double dt : {1e-6, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0, 10.0}) {
      if (dt > 1 && TypeParam::info.name == "srkmk3") continue;  // dexp_inv has a pole at |u| = 2 pi
      const auto scene = with_parts({1, 2, 3}, 0.5, isotropic);
      const auto s = bind_scene(scene);
      const increments w(*s.model, steps, dt);
      const auto stepper = kernel_on<TypeParam>(scene, dt);
      const auto system = prepared<TypeParam>(make_rigid_body(scene), dt);
      for (int i = 0; i < steps; ++i) {
        auto states = replicated(scene.momentum);
        stepper->advance(states, w.step(i));
        for (int lane = 0; lane < block_lanes; ++lane) {
          const auto mu = TypeParam::step(system, paper_momentum, w.at(i, lane));
          const double size = std::sqrt(dot(mu, mu));
          ++tried;
          if (!std::isfinite(size)) continue;  // an implicit step that found no solution
          ++compared;
          EXPECT_LE(distance(mu, state_at(states, lane)), 2e-14 * std::max(1.0, size))
              << TypeParam::info.name << " on " << name_of(level) << ", dt " << dt;
        }
      }
    }
  }
  EXPECT_GT(compared, tried / 2) << TypeParam::info.name;
}

template <class Scheme, rotation_size size>
void expect_the_step_at_the_end_of_polynomials(double dt) {
  auto scene = at_the_end_of_polynomials<size>(dt);
  EXPECT_EQ(rotation_size_of(make_rigid_body(scene), 1, dt), size);
  for (const isa level : usable_isas()) {
    choose_isa(level);
    EXPECT_LE(distance_from_the_step<Scheme>(*kernel_on<Scheme>(scene, dt), scene), 2e-14)
        << Scheme::info.name << " on " << name_of(level) << ", dt " << dt;
  }
  scene.number("theta") *= 1.001;
  EXPECT_GT(rotation_size_of(make_rigid_body(scene), 1, dt), size);
}

// Where a polynomial errs most: from everywhere on the sphere, with as much dissipation as its size allows.
TYPED_TEST(Kernel, AgreesWithTheScalarStepAtTheEndOfEveryPolynomial) {
  expect_the_step_at_the_end_of_polynomials<TypeParam, rotation_size::tiny>(0.01);
  expect_the_step_at_the_end_of_polynomials<TypeParam, rotation_size::moderate>(0.1);
}

TYPED_TEST(Kernel, PiecesAndStopsChangeNothing) {
  constexpr int steps = 24;
  constexpr double dt = 0.01;
  const auto scene = load_scene("paper");
  const auto s = bind_scene(scene);
  const increments w(*s.model, steps, dt);
  const auto stepper = kernel_on<TypeParam>(scene, dt);
  EXPECT_EQ(stepper->dt(), dt);
  auto whole = replicated(scene.momentum), pieces = whole;
  stepper->advance(whole, w.view);
  for (int i = 0; i < steps; ++i) stepper->advance(pieces, w.step(i), {i == 0, i + 1 == steps});
  EXPECT_EQ(whole, pieces);
  EXPECT_EQ(distance_of_a_look(*stepper, scene), 0) << "a look in between is the run that ends there";
}

TYPED_TEST(Kernel, ALaneDoesNotSeeItsNeighbours) {
  constexpr double dt = 0.01;
  const auto scene = load_scene("paper");
  const auto s = bind_scene(scene);
  increments w(*s.model, 1, dt);
  const auto stepper = kernel_on<TypeParam>(scene, dt);
  auto alone = replicated(scene.momentum), beside = alone;
  stepper->advance(alone, w.view);
  for (int lane = 1; lane < block_lanes; ++lane) w.dw[static_cast<std::size_t>(lane)] = 20;  // 10 rad
  stepper->advance(beside, w.view);
  EXPECT_EQ(distance(state_at(alone, 0), state_at(beside, 0)), 0.0);
}

// Fast increments come as floats in a unit of their own; areas as they are.
TYPED_TEST(Kernel, SinglesAreIncrementsInTheirUnit) {
  constexpr int steps = 30;
  constexpr double dt = 0.01, unit = 0.1;
  for (const auto& scene : every_part()) {
    const auto s = bind_scene(scene);
    increments w(*s.model, steps, dt);
    std::vector<float> singles;
    for (double& dw : w.dw) {
      singles.push_back(static_cast<float>(dw / unit));
      dw = unit * double{singles.back()};
    }
    const auto stepper = kernel_on<TypeParam>(scene, dt);
    auto doubles = replicated(scene.momentum), floats = doubles;
    stepper->advance(doubles, w.view);
    stepper->advance(floats, {steps, {}, w.area, singles, unit});
    for (const int lane : {0, 17, block_lanes - 1})
      EXPECT_LE(distance(state_at(doubles, lane), state_at(floats, lane)), 1e-14) << TypeParam::info.name;
  }
}

TEST(PlainKernel, SinglesAreIncrementsInTheirUnit) {
  constexpr double dt = 0.01, unit = 0.1;
  const kernel_of<heun, plain_forms<so4_body>, pack> plain{plain_forms(coupled_bodies()), dt};
  const kernel& stepper = plain;
  const std::vector<double> momentum{0.6, 0.48, 0.64, -0.3, 0.8, 0.5};
  std::vector<float> singles;
  std::vector<double> dw;
  for (int i = 0; i < so4::dimension * block_lanes; ++i) {
    singles.push_back(static_cast<float>(std::sin(i)));
    dw.push_back(unit * double{singles.back()});
  }
  auto doubles = replicated(momentum), floats = doubles;
  stepper.advance(doubles, {1, dw, {}});
  stepper.advance(floats, {1, {}, {}, singles, unit});
  EXPECT_EQ(doubles, floats);
}

TYPED_TEST(Kernel, ASharedNoiseIsEveryPathsNoise) {
  for (const auto& scene : every_part())
    EXPECT_LE(distance_of_common_noise(*kernel_on<TypeParam>(scene, 0.004), scene), 1e-13) << TypeParam::info.name;
}

}  // namespace
}  // namespace polhode::test
