// SPDX-License-Identifier: Apache-2.0
// The distance of Kolmogorov and Smirnov.
#include "statistics/sample.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace polhode {
namespace {

TEST(KolmogorovSmirnov, DistanceOfASmallSampleByHand) {
  const std::vector<double> x{0.1, 0.4, 0.9};
  EXPECT_NEAR(ks_distance(x, [](double t) { return t; }).value, 2.0 / 3 - 0.4, 1e-15);
}

}  // namespace
}  // namespace polhode
