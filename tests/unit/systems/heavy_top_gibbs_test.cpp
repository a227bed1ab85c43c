// SPDX-License-Identifier: Apache-2.0
// The Gibbs law of the heavy top: an independent computation, and what equipartition says.
#include <gtest/gtest.h>

#include <cmath>

#include "systems/heavy_top/heavy_top_gibbs.hpp"

namespace polhode {
namespace {

double mean(const heavy_top_gibbs& law, std::string_view name) {
  const auto found = law.mean(name);
  EXPECT_TRUE(found && found->value) << name;
  if (!found || !found->value) return NAN;
  EXPECT_EQ(found->reason, "") << name;
  return *found->value;
}

TEST(HeavyTopGibbs, HasTheMomentsOfAnIndependentComputation) {
  const heavy_top_gibbs law{{1, 2, 3}, {0, 0, 1}, 0.5, 4};
  EXPECT_NEAR(mean(law, "energy"), -0.434726363524, 1e-11);
  EXPECT_NEAR(mean(law, "gamma3"), -0.739105226731, 1e-11);
  EXPECT_NEAR(mean(law, "gamma1^2"), 0.198138011136, 1e-11);
}

/// A spherical top without weight: Gamma is uniform, Pi.Gamma = k, and Pi across Gamma has variance I / beta twice.
TEST(HeavyTopGibbs, OfASphericalTopIsEquipartition) {
  const heavy_top_gibbs law{{2, 2, 2}, {0, 0, 0}, 0.7, 3};
  EXPECT_NEAR(mean(law, "energy"), 1.0 / 3 + 0.49 / 4, 1e-12);
  for (const auto* square : {"pi1^2", "pi2^2", "pi3^2"})
    EXPECT_NEAR(mean(law, square), (2 * 2.0 / 3 + 0.49) / 3, 1e-12);
  for (const auto* square : {"gamma1^2", "gamma2^2", "gamma3^2"}) EXPECT_NEAR(mean(law, square), 1.0 / 3, 1e-12);
}

/// Without momentum along Gamma the moments of Pi and of Gamma give back the energy.
TEST(HeavyTopGibbs, MomentsAddUpToTheEnergy) {
  const heavy_top_gibbs law{{1, 1.5, 2.2}, {0.24, -0.32, 0.48}, 0.9, 3.75};
  double energy = 0;
  for (int k = 0; k < 3; ++k)
    energy += mean(law, "pi" + std::to_string(k + 1) + "^2") / (2 * law.inertia[k]) +
              law.pull[k] * mean(law, "mu_" + std::to_string(k + 4));
  EXPECT_NEAR(mean(law, "energy"), energy, 1e-12);
}

TEST(HeavyTopGibbs, SaysSoWhereTheLawIsTooNarrow) {
  const auto found = heavy_top_gibbs{{1, 2, 3}, {0, 0, 1}, 0, 1e9}.mean("energy");
  ASSERT_TRUE(found);
  EXPECT_NE(found->reason, "");
  EXPECT_FALSE(heavy_top_gibbs({{1, 2, 3}, {0, 0, 1}, 0, 1}).mean("s1_3"));
}

}  // namespace
}  // namespace polhode
