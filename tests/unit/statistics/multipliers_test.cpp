// SPDX-License-Identifier: Apache-2.0
// What an extrapolation leaves open is at least what it leaves of a geometric series, and no more than was corrected.
#include "statistics/multipliers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace polhode {
namespace {

const std::vector<double> dt{0.08, 0.04, 0.02, 0.01};

struct extrapolation {
  double limit, first, second;
};
template <class function>
extrapolation at_zero(const function& f) {
  const auto line = constant_of_polynomial(dt, 1), quadratic = constant_of_polynomial(dt, 2);
  double by_line = 0, limit = 0;
  for (std::size_t l = 0; l < dt.size(); ++l) {
    by_line += line[static_cast<Eigen::Index>(l)] * f(dt[l]);
    limit += quadratic[static_cast<Eigen::Index>(l)] * f(dt[l]);
  }
  return {limit, f(dt.back()) - limit, by_line - limit};
}

TEST(LeftOpen, IsWhatIsLeftOfAGeometricSeries) {
  for (const double rate : {0.01, 0.1, 1.0, -1.0}) {
    const auto found = at_zero([=](double x) { return 1 / (1 - rate * x); });
    const double open = left_open(dt, found.first, found.second, 0), left = std::fabs(found.limit - 1);
    EXPECT_NEAR(open / left, 1, 3 * std::fabs(rate) * dt.front()) << rate;
    EXPECT_LT(open, std::fabs(found.second)) << rate;
  }
}

TEST(LeftOpen, IsAllOfTheCorrectionWhereItIsNoSmallerThanTheOneBefore) {
  const auto square = at_zero([](double x) { return x * x; });
  EXPECT_NEAR(square.limit, 0, 1e-15);
  EXPECT_EQ(left_open(dt, 0, 0.25, 0), 0.25);
  EXPECT_EQ(left_open(dt, 1e-9, -0.25, 0), 0.25);
}

TEST(LeftOpen, IsNothingThatIsWithinItsError) {
  EXPECT_EQ(left_open(dt, 0.5, 0.019, 0.01), 0);
  EXPECT_GT(left_open(dt, 0.5, 0.021, 0.01), 0);
  EXPECT_EQ(left_open(dt, 0, 0, 0), 0);
}

}  // namespace
}  // namespace polhode
