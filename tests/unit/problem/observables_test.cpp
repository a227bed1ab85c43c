// SPDX-License-Identifier: Apache-2.0
// Names become functions of the state, for every system.
#include <gtest/gtest.h>

#include <cmath>

#include "problem/observables.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

double value(const char* scene, const char* name) {
  const auto s = bind_scene(load_scene(scene));
  const auto f = observable_of(s, name);
  return f ? (*f)(s.scene.momentum) : NAN;
}

TEST(Observables, HaveTheNamesOfTheirSystem) {
  EXPECT_EQ(value("heavy_top", "pi3"), 0.7);
  EXPECT_EQ(value("heavy_top", "gamma2"), 0.6);
  EXPECT_EQ(value("heavy_top", "gamma2^2"), 0.36);
  EXPECT_EQ(value("spin_pair", "s1_3"), 0.8);
  EXPECT_EQ(value("spin_pair", "s2_1^2"), 1.0);
  EXPECT_EQ(value("maxwell_bloch", "x2"), 0.6);
  EXPECT_EQ(value("paper", "pi1"), 0.6);
  EXPECT_NEAR(value("paper", "exp(pi3)"), std::exp(0.64), 1e-15);
}

TEST(Observables, KnowComponentsByNumberEverywhere) {
  EXPECT_EQ(value("so4", "mu_4"), -0.3);
  EXPECT_EQ(value("heavy_top", "mu_5"), 0.6);
  EXPECT_EQ(value("spin_pair", "mu_3^2"), 0.8 * 0.8);
  EXPECT_EQ(value("paper", "mu_2"), 0.48);
}

TEST(Observables, HaveNoOtherNames) {
  for (const char* name : {"mu_7", "mu_0", "s1_3", "exp(pi3)", "", "^2", "energy^2"})
    EXPECT_TRUE(std::isnan(value("heavy_top", name))) << name;
}

// h = Pi.I^-1 Pi / 2 + weight Gamma.axis, by hand.
TEST(Observables, TheEnergyIsThatOfTheSystem) {
  const double h = 0.5 * (0.25 + 0.09 / 1.5 + 0.49 / 2.2) + 0.8 * (0.3 * 0.48 - 0.4 * 0.6 + 0.6 * 0.64);
  EXPECT_NEAR(value("heavy_top", "energy"), h, 1e-15);
}

TEST(Observables, OfALongStateTheFirst) {
  const auto s = bind_scene(load_scene("spin_ring"));
  const auto all = observables_of(s, 2);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0].name, "energy");
  EXPECT_EQ(all[2].name, "s1_2");
  EXPECT_EQ(all[4].name, "s1_2^2");
  for (const auto& o : all) EXPECT_EQ(o.value(s.scene.momentum), (*observable_of(s, o.name))(s.scene.momentum));
}

}  // namespace
}  // namespace polhode
