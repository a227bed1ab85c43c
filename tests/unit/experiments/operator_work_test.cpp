// SPDX-License-Identifier: Apache-2.0
// Which of the measured times a forecast takes of a scene on a sphere.
#include "experiments/common/operator_work.hpp"

#include <gtest/gtest.h>

#include "run/bind_scene.hpp"
#include "scene/scene.hpp"

namespace polhode {
namespace {

double of(const scene& s) { return by_sphere(bind_scene(s), 1, 2, 3); }

TEST(OperatorWork, IsThatOfTheKindOfNoise) {
  EXPECT_EQ(of(load_scene("paper")), 1);
  EXPECT_EQ(of(load_scene("anisotropic")), 1);
  EXPECT_EQ(of(load_scene("single")), 2);
  EXPECT_EQ(of(with_noise_vectors(load_scene("paper"), {{0.3, 0.2, 0.1}})), 2);
}

TEST(OperatorWork, IsThatOfAFieldOrOfNoiseThatDependsOnTheState) {
  EXPECT_EQ(of(load_scene("thermal_spin")), 3);
  EXPECT_EQ(of(load_scene("spin")), 3);
  EXPECT_EQ(of(with_noise_vectors(load_scene("spin"), {{0.3, 0.2, 0.1}})), 3);
}

TEST(OperatorWork, IsAPartOfThatWithoutNoise) {
  const double part = of(load_scene("free"));
  EXPECT_GT(part, 0);
  EXPECT_LT(part, 1);
}

}  // namespace
}  // namespace polhode
