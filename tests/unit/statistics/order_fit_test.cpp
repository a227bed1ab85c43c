// SPDX-License-Identifier: Apache-2.0
// The fit of an order: exact powers, floors, divergence, and an interval that covers as often as it says.
#include "statistics/orders/order_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <polhode/noise/normal.hpp>

#include "statistics/orders/level_choice.hpp"
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"
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

// Residuals a, -a, -a, a leave the line where it is. Student's quantile of two degrees is (2 p - 1) / sqrt(2 p (1 -
// p)).
TEST(OrderFit, IntervalOfExactValuesIsStudentsFromTheirScatter) {
  const auto dt = halvings(4);
  const std::vector<double> off{0.01, -0.01, -0.01, 0.01};
  std::vector<double> value;
  for (std::size_t i = 0; i < 4; ++i) value.push_back(3 * std::pow(dt[i], 1.5) * std::exp2(off[i]));
  const double half = 0.95 / std::sqrt(2 * 0.975 * 0.025) * std::sqrt(4 * 1e-4 / 2 / 5);
  for (const auto& fit : {fit_order(dt, value, 0), fit_power_law(dt, value)}) {
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->order, 1.5, 1e-13);
    EXPECT_NEAR(fit->low, 1.5 - half, 1e-12);
    EXPECT_NEAR(fit->high, 1.5 + half, 1e-12);
    EXPECT_NEAR(fit->finest.value, 1.5 - 0.02, 1e-12);
  }
}

// Without sampling error nothing explains that the coarsest lies off the line; a value at the floor is no level.
TEST(OrderFit, ExactLevelsOffTheLineOrAtTheFloorAreLeftOut) {
  const auto dt = halvings(7);
  std::vector<double> value;
  for (const double h : dt) value.push_back(h * h);
  value[0] *= 1.5;
  const auto fit = fit_order(dt, value, value[6]);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->used, (std::vector{false, true, true, true, true, true, false}));
  EXPECT_NEAR(fit->order, 2, 1e-13);
  EXPECT_EQ(
      fit->rule,
      "5 levels used; left out: 0 coarser than the finest 6, 1 pre-asymptotic, 1 at the rounding floor or not finite");
}

TEST(OrderFit, AGrowthLawHasNoLevelAtZero) {
  const std::vector<double> x{1, 2, 5, 9, 20}, value{0, 4, 25, 81, 400};
  const auto fit = fit_power_law(x, value);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 2, 1e-13);
  EXPECT_EQ(fit->used, (std::vector{false, true, true, true, true}));
}

/// Paths that scatter at each level by another share, general steps.
const std::vector<double> general_dt{0.31, 0.17, 0.08, 0.045, 0.02, 0.011};

squared_errors scattered_errors(const std::vector<double>& dt, int paths, double order) {
  squared_errors e{paths, static_cast<int>(dt.size()), {}};
  for (int path = 0; path < paths; ++path)
    for (std::size_t l = 0; l < dt.size(); ++l) {
      const auto z = normals<1>({11, noise_kind::increment, static_cast<std::uint64_t>(path), l});
      const double share = l % 2 == 0 ? 0.5 : 0.1 + 0.1 * static_cast<double>(l);
      e.values.push_back(std::pow(dt[l], 2 * order) * std::exp(share * z[0] - share * share / 2));
    }
  return e;
}

/// log2 (mean |error|^p)^(1/p) at level i with its standard error, sums by hand.
log_level level_of(const std::vector<double>& dt, const squared_errors& e, double p, int i) {
  double mean = 0, square = 0;
  for (int path = 0; path < e.paths; ++path) mean += std::pow(e.at(path, i), p / 2) / e.paths;
  for (int path = 0; path < e.paths; ++path) square += std::pow(std::pow(e.at(path, i), p / 2) - mean, 2);
  const double error = std::sqrt(square / (e.paths - 1) / e.paths);
  return {i, std::log2(dt[static_cast<std::size_t>(i)]), std::log2(mean) / p, error / mean / std::numbers::ln2 / p};
}

std::vector<log_level> levels_of(const std::vector<double>& dt, const squared_errors& e, double p) {
  std::vector<log_level> out;
  for (int i = 0; i < e.levels; ++i) out.push_back(level_of(dt, e, p, i));
  return out;
}

/// The levels of every replicate.
std::vector<std::vector<log_level>> replicates_of(const std::vector<double>& dt, const squared_errors& e, double p,
                                                  std::uint64_t seed) {
  values_of_paths values = matrix_of(e);
  for (double& x : values.reshaped()) x = std::pow(x, p / 2);
  const auto means = resampled_means(values, seed);
  std::vector<std::vector<log_level>> out;
  for (Eigen::Index r = 0; r < means.rows(); ++r) {
    out.push_back(levels_of(dt, e, p));
    for (auto& l : out.back()) l.y = std::log2(means(r, l.index)) / p;
  }
  return out;
}

// Of 164 paths the interval ends at a replicate next to which a wider or a shorter one would begin.
constexpr int telling_paths = 164;

TEST(OrderFit, SampledIntervalsAreThoseOfTheReplicatesLines) {
  const auto e = scattered_errors(general_dt, telling_paths, 0.8);
  const std::array norms{error_norm{&e, 2}, error_norm{&e, 3}};
  const auto fits = fit_orders(general_dt, norms, 0, 7);
  for (std::size_t n = 0; n < norms.size(); ++n) {
    ASSERT_TRUE(fits[n]);
    const auto& fit = *fits[n];
    const auto kept = asymptotic_part(levels_of(general_dt, e, norms[n].p));
    EXPECT_EQ(std::ranges::count(fit.used, true), std::ssize(kept));
    const auto line = line_through(kept);
    EXPECT_NEAR(fit.order, line.slope, 1e-12);
    EXPECT_NEAR(fit.prefactor, std::exp2(line.intercept), 1e-12);
    std::vector<double> slopes, finest;
    for (const auto& levels : replicates_of(general_dt, e, norms[n].p, 7)) {
      slopes.push_back(line_through(asymptotic_part(levels)).slope);
      finest.push_back((levels[5].y - levels[4].y) / (levels[5].x - levels[4].x));
    }
    const auto [low, high] = bootstrap_interval(slopes, 0.95, telling_paths);
    const auto [slowest, fastest] = bootstrap_interval(finest, 0.95, telling_paths);
    EXPECT_NEAR(fit.low, low, 1e-12);
    EXPECT_NEAR(fit.high, high, 1e-12);
    EXPECT_NEAR(fit.finest.low, slowest, 1e-12);
    EXPECT_NEAR(fit.finest.high, fastest, 1e-12);
  }
}

/// The same but for the coarsest level, whose root mean square is 2^by times as large.
squared_errors lifted(squared_errors e, double by) {
  for (int path = 0; path < e.paths; ++path) e.at(path, 0) *= std::exp2(2 * by);
  return e;
}

TEST(OrderFit, ACoarseLevelIsLeftOutBeyondThreeOfItsStandardErrors) {
  const std::vector<double> dt(general_dt.begin(), general_dt.begin() + 5);
  const auto e = scattered_errors(dt, 40, 0.8);
  const auto levels = levels_of(dt, e, 2);
  const double off = off_the_others(levels), error = levels.front().error;
  ASSERT_GT(3 * error, 0.06);
  EXPECT_TRUE(fit_order(dt, lifted(e, 3 * error * 0.9995 - off), 0, 1)->used[0]);
  EXPECT_FALSE(fit_order(dt, lifted(e, 3 * error * 1.0005 - off), 0, 1)->used[0]);
}

// Four levels all stay; by how much the coarsest is off has an interval, whose ends are moved to either side of 0.05.
TEST(OrderFit, SettlesWhereTheIntervalOfTheCoarsestLevelTouchesTheMargin) {
  const std::vector<double> dt(general_dt.begin(), general_dt.begin() + 4);
  const auto e = scattered_errors(dt, telling_paths, 0.8);
  std::vector<double> off;
  for (const auto& levels : replicates_of(dt, e, 2, 3)) off.push_back(off_the_others(levels));
  const auto [least, most] = bootstrap_interval(off, 0.95, telling_paths);
  double below = -HUGE_VAL, above = HUGE_VAL;
  for (const double x : off) {
    if (x < least) below = std::max(below, x);
    if (x > most) above = std::min(above, x);
  }
  const auto settled = [&](double by) { return fit_order(dt, lifted(e, by), 0, 3)->asymptotic; };
  const double up = (least - below) / 2, down = (above - most) / 2;
  EXPECT_TRUE(settled(0.05 - least - up));
  EXPECT_FALSE(settled(0.05 - least + up));
  EXPECT_TRUE(settled(-0.05 - most + down));
  EXPECT_FALSE(settled(-0.05 - most - down));
}

TEST(OrderFit, ANormWithoutEnoughLevelsLeavesTheOthersAlone) {
  const auto e = scattered_errors(general_dt, 50, 0.8);
  auto few = e;
  for (int path = 0; path < e.paths; ++path)
    for (const int l : {0, 2, 5}) few.at(path, l) = 0;
  const std::array norms{error_norm{&few, 2}, error_norm{&e, 2}};
  const auto fits = fit_orders(general_dt, norms, 0, 5);
  EXPECT_FALSE(fits[0]);
  EXPECT_EQ(fits[1]->low, fit_order(general_dt, e, 0, 5)->low);
  for (int path = 0; path < e.paths; ++path) few.at(path, 0) = e.at(path, 0);
  const auto four = fit_order(general_dt, few, 0, 5);
  ASSERT_TRUE(four);
  EXPECT_EQ(
      four->rule,
      "4 levels used; left out: 0 coarser than the finest 6, 0 pre-asymptotic, 2 at the rounding floor or not finite");
}

// Of two paths 2 and 4: a mean of three standard errors.
TEST(ClearMeans, AreThoseOfAsManyStandardErrorsAsAreAsked) {
  const auto dt = halvings(5);
  squared_errors values{2, 5, {}};
  for (const double size : {2.0, 4.0})
    for (std::size_t l = 0; l < 5; ++l) values.values.push_back((l == 1 ? -1 : 1) * size * dt[l]);
  const auto all = fit_order_of_clear_means(dt, values, 3, 1);
  ASSERT_TRUE(all);
  EXPECT_EQ(all->used, std::vector<bool>(5, true));
  EXPECT_NEAR(all->order, 1, 1e-13);
  EXPECT_FALSE(fit_order_of_clear_means(dt, values, std::nextafter(3, 4), 1));
  values.at(0, 2) *= -1;  // a mean of a third of its standard error
  const auto without = fit_order_of_clear_means(dt, values, 3, 1);
  ASSERT_TRUE(without);
  EXPECT_EQ(without->used, (std::vector{true, true, false, true, true}));
}

TEST(PowerOfMeans, IsThatOfFourLevelsOrMore) {
  const std::vector<double> x{1, 2, 5, 9};
  squared_errors values{3, 4, {}};
  for (const double size : {1.0, 2.0, 4.0})
    for (const double at : x) values.values.push_back(size * at * at * at);
  EXPECT_NEAR(power_of_means(x, values).value_or(0), 3, 1e-13);
  for (int path = 0; path < 3; ++path) values.at(path, 1) *= -1;
  EXPECT_FALSE(power_of_means(x, values));
}

// Means of 1, 1/2, 1/8, 1/16 that are exact, of paths that differ by 2^-35 of them or not at all.
TEST(PowerOfMeans, ALevelWithoutScatterWeighsAsOneKnownTo12Digits) {
  const std::vector<double> x{0.5, 0.25, 0.125, 0.0625}, mean{1, 0.5, 0.125, 0.0625};
  constexpr int paths = 32;
  squared_errors values{paths, 4, {}};
  for (int path = 0; path < paths; ++path)
    for (std::size_t l = 0; l < 4; ++l)
      values.values.push_back(mean[l] * (1 + (l % 2 == 0 ? 0 : path % 2 == 0 ? 0x1p-36 : -0x1p-36)));
  const double error = 0x1p-36 / std::sqrt(paths - 1.0) / std::numbers::ln2;
  const std::vector<log_level> levels{{0, -1, 0, 1e-12}, {1, -2, -1, error}, {2, -3, -3, 1e-12}, {3, -4, -4, error}};
  EXPECT_NEAR(power_of_means(x, values).value_or(0), line_through(levels).slope, 1e-10);
}

// The coarsest lies on the line of the others, which scatter by more than is settled.
TEST(OrderFit, ExactLevelsThatScatterHaveNotSettled) {
  const auto dt = halvings(4);
  for (const double b : {0.01, 0.06}) {
    const std::vector<double> off{0, b, -2 * b, b};
    std::vector<double> value;
    for (std::size_t i = 0; i < 4; ++i) value.push_back(dt[i] * std::exp2(off[i]));
    const auto fit = fit_order(dt, value, 0);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->used, std::vector<bool>(4, true));
    EXPECT_EQ(fit->asymptotic, b < 0.02);
  }
}

}  // namespace
}  // namespace polhode
