// SPDX-License-Identifier: Apache-2.0
// Energies of pairs: of exchange, and of vortices next to each other and where they meet.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <polhode/systems/pair_energy.hpp>

namespace polhode {
namespace {

const vec<double, 3> a{{0.3, -0.7, 1.1}}, b{{-0.2, 0.5, 0.4}};

TEST(PairEnergy, IsOfExchangeWhereNoStrengthsOfVorticesAreGiven) {
  const pair_energy pair{0, 1, 0.6};
  EXPECT_TRUE(pair.is_exchange());
  EXPECT_EQ(pair.slope(a, b), 0.6);
  EXPECT_NEAR(pair.value(a, b), 0.6 * (-0.06 - 0.35 + 0.44), 1e-16);
}

// Of x_i.x_j = cos(2 phi) the logarithm is that of 2 sin(phi)^2.
TEST(PairEnergy, OfVorticesIsTheLogarithmOfTheirGapHoweverNarrow) {
  const double first = 0.8, second = -0.5;
  const auto pair = pair_energy::of_vortices(0, 1, first, second);
  EXPECT_FALSE(pair.is_exchange());
  for (const double phi : {1.0, 0.1, 1e-2, 1e-3, 1e-6}) {
    const vec<double, 3> x{{first * std::cos(phi), first * std::sin(phi), 0}};
    const vec<double, 3> y{{second * std::cos(phi), -second * std::sin(phi), 0}};
    const double gap = 2 * std::sin(phi) * std::sin(phi);
    EXPECT_NEAR(pair.value(x, y), 0.4 / (4 * std::numbers::pi) * std::log(gap), 1e-13) << phi;
    EXPECT_NEAR(pair.slope(x, y) * gap * 4 * std::numbers::pi, 1, 1e-9) << phi;
  }
}

// They have left behind all energy where they are alike, or taken up all where they are not.
TEST(PairEnergy, OfVorticesThatMeetIsInfinite) {
  EXPECT_EQ(pair_energy::of_vortices(0, 1, 1, 1).value(a, a), INFINITY);
  EXPECT_EQ(pair_energy::of_vortices(0, 1, 1, -1).value(a, -a), -INFINITY);
}

}  // namespace
}  // namespace polhode
