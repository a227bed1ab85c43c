// SPDX-License-Identifier: Apache-2.0
// Every scheme takes floats, on every system that ships: the step of a double but for rounding.
#include <gtest/gtest.h>

#include "support/heavy_top.hpp"
#include "support/maxwell_bloch.hpp"
#include "support/schemes.hpp"
#include "support/spin.hpp"

namespace polhode::test {
namespace {

template <class Scheme>
struct FloatConformance : testing::Test {};
TYPED_TEST_SUITE(FloatConformance, every_scheme);

template <class Scheme, class System>
void same_but_for_rounding(const System& system, const state_of<System>& mu) {
  constexpr double dt = 0.05;
  const auto stepped = prepared<Scheme>(system, dt);
  wiener_levy<double, System::channels> w;
  wiener_levy<float, System::channels> single;
  w.dt = single.dt = dt;
  for (int i = 0; i < w.dw.size; ++i) w.dw[i] = single.dw[i] = 0.125F * static_cast<float>(1 - i % 3);
  for (int i = 0; i < w.area.size; ++i) w.area[i] = single.area[i] = 0.015625F * static_cast<float>(i % 2);
  state_of<System, float> start;
  for (int i = 0; i < start.size; ++i) start[i] = static_cast<float>(mu[i]);
  const auto expected = Scheme::step(stepped, mu, w);
  const state_of<System, float> found = Scheme::step(stepped, start, single);
  for (int i = 0; i < found.size; ++i) EXPECT_NEAR(found[i], expected[i], 4e-6) << Scheme::info.name << ' ' << i;
}

TYPED_TEST(FloatConformance, AStepIsThatOfDoublesButForRounding) {
  const vec<double, 6> bodies{{0.6, 0.48, 0.64, -0.3, 0.8, 0.5}};
  same_but_for_rounding<TypeParam>(paper_body(), paper_momentum);
  same_but_for_rounding<TypeParam>(coupled_bodies(), bodies);
  same_but_for_rounding<TypeParam>(tilted_spin(), paper_momentum);
  if constexpr (scheme_on<TypeParam, heavy_top>) same_but_for_rounding<TypeParam>(asymmetric_top(), top_state);
  if constexpr (scheme_on<TypeParam, maxwell_bloch>) same_but_for_rounding<TypeParam>(atoms_in_light(), paper_momentum);
}

}  // namespace
}  // namespace polhode::test
