// SPDX-License-Identifier: Apache-2.0
// The fit of an order: exact powers, floors, divergence, and an interval that covers as often as it says.
#include "statistics/orders/order_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <polhode/noise/normal.hpp>

#include "support/halvings.hpp"

namespace polhode {
namespace {

using test::halvings;

TEST(OrderFit, FindsAPowerExactly) {
  const auto dt = halvings(6);
  std::vector<double> value;
  for (const double h : dt) value.push_back(3 * std::pow(h, 1.5));
  const auto fit = fit_order(dt, value, 0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 1.5, 1e-12);
  EXPECT_NEAR(fit->prefactor, 3, 1e-9);
  EXPECT_NEAR(fit->low, 1.5, 1e-9);
}

TEST(OrderFit, LeavesOutTheFloorAndTheCoarse) {
  const auto dt = halvings(9);
  std::vector<double> value;
  for (const double h : dt) value.push_back(std::max(h * h * (1 + 30 * h), 2e-7));
  const auto fit = fit_order(dt, value, 3e-7);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 2, 0.2);
  EXPECT_FALSE(fit->used.front());
}

TEST(OrderFit, DivergenceIsNotConvergence) {
  const auto dt = halvings(6);
  std::vector<double> value;
  for (const double h : dt) value.push_back(1 / h);
  EXPECT_NEAR(fit_order(dt, value, 0)->order, -1, 1e-12);
}

TEST(OrderFit, RefusesFewerThanFourLevels) {
  const std::vector<double> dt{0.5, 0.25, 0.125}, value{1, 0.5, 0.25};
  EXPECT_FALSE(fit_order(dt, value, 0));
  const std::vector<double> more{0.5, 0.25, 0.125, 0.06, 0.03}, lost{NAN, 1, 0.5, 0.25, INFINITY};
  EXPECT_FALSE(fit_order(more, lost, 0));
}

// The interval's promise, tested as such: of 200 experiments about 95 % must cover the truth.
TEST(OrderFit, IntervalCoversTheTruthAsOftenAsItSays) {
  const auto dt = halvings(6);
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    squared_errors e{200, 6, {}};
    for (std::uint64_t path = 0; path < 200; ++path)
      for (std::size_t l = 0; l < dt.size(); ++l) {
        const auto z = normals<2>({seed, noise_kind::increment, path, l});  // levels independent: the harder case
        e.values.push_back(dt[l] * (z[0] * z[0] + z[1] * z[1]));
      }
    const auto fit = fit_order(dt, e, 0, seed);
    covered += fit->low <= 0.5 && 0.5 <= fit->high;
  }
  EXPECT_GE(covered, 180);  // 190 expected, standard deviation 3
  EXPECT_LE(covered, 199);
}

TEST(OrderFit, SampledSlopesSettleOrNot) {
  const auto dt = halvings(4);
  squared_errors bent{400, 4, {}}, straight = bent;
  for (int path = 0; path < 400; ++path) {
    const auto z = normals<2>({1, noise_kind::increment, static_cast<std::uint64_t>(path), 0});
    for (const double h : dt) {
      const double size = z[0] * z[0] + z[1] * z[1];
      bent.values.push_back(std::pow(h + 20 * h * h, 2) * size);
      straight.values.push_back(h * h * size);
    }
  }
  EXPECT_FALSE(fit_order(dt, bent, 0, 1)->asymptotic);
  EXPECT_TRUE(fit_order(dt, straight, 0, 1)->asymptotic);
}

}  // namespace
}  // namespace polhode
