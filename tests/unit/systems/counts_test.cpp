// SPDX-License-Identifier: Apache-2.0
// How many components and Wiener processes a system has: stated in its type, 0 of them too, or by its object alone.
#include <gtest/gtest.h>

#include <polhode/systems/lie_poisson.hpp>

namespace polhode {
namespace {

struct silent {
  static constexpr int dimension = 3, channels = 0;
};

struct of_any_size {
  static constexpr int dimension = -8, channels = -8;
  int components() const { return 5; }
};

TEST(Counts, AreThoseOfTheTypeOrOfTheObject) {
  EXPECT_EQ(dimension_of(silent{}), 3);
  EXPECT_EQ(channels_of(silent{}), 0);
  EXPECT_EQ(dimension_of(of_any_size{}), 5);
  EXPECT_EQ(channels_of(of_any_size{}), 5);
}

}  // namespace
}  // namespace polhode
