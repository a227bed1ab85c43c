// SPDX-License-Identifier: Apache-2.0
// Orders in other norms than the mean square, and of single paths: what one sees and another does not.
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/noise/normal.hpp>

#include "statistics/orders/path_slopes.hpp"
#include "support/halvings.hpp"

namespace polhode {
namespace {

using test::halvings;

/// Squares of error(path, dt).
template <class Error>
squared_errors errors_of(const std::vector<double>& dt, int paths, Error error) {
  squared_errors e{paths, static_cast<int>(dt.size()), {}};
  for (int p = 0; p < paths; ++p)
    for (const double h : dt) e.values.push_back(std::pow(error(p, h), 2));
  return e;
}

double normal_at(std::uint64_t seed, int path) {
  return normals<1>({seed, noise_kind::increment, static_cast<std::uint64_t>(path), 0})[0];
}

// An error of sqrt(dt) with probability dt, else dt: mean square 2 dt^2, fourth moment dt^3.
TEST(Norms, TheFourthMomentSeesRareErrorsThatTheMeanSquareDoesNot) {
  constexpr int paths = 4096;
  const auto dt = halvings(8, 0.25);
  const auto e = errors_of(dt, paths, [&](int p, double h) { return p < paths * h ? std::sqrt(h) : h; });
  const std::array norms{error_norm{&e, 1}, error_norm{&e, 2}, error_norm{&e, 4}};
  const auto fits = fit_orders(dt, norms, 0, 1);
  EXPECT_NEAR(fits[0]->order, 1, 0.1);
  EXPECT_NEAR(fits[1]->order, 1, 0.03);
  EXPECT_NEAR(fits[2]->order, 0.75, 0.03);
  EXPECT_LT(fits[2]->high, 0.9);
  EXPECT_LT(fits[1]->low, fits[1]->order);
}

TEST(Norms, OfTheMeanSquareAreThoseOfFitOrder) {
  const auto dt = halvings(6, 0.25);
  const auto e = errors_of(dt, 300, [](int p, double h) { return h * normal_at(5, p) + h * h; });
  const error_norm rms{&e, 2};
  const auto one = fit_order(dt, e, 0, 9), other = fit_orders(dt, {&rms, 1}, 0, 9).front();
  EXPECT_EQ(one->order, other->order);
  EXPECT_EQ(one->low, other->low);
  EXPECT_NEAR(level_norm(e, 2, 3).mean, std::sqrt(level_mean(e, 3).mean), 1e-15);
  EXPECT_GE(level_norm(e, 4, 3).mean, level_norm(e, 2, 3).mean);
  EXPECT_GE(level_norm(e, 2, 3).mean, level_norm(e, 1, 3).mean);
}

TEST(PathSlopes, AreThoseOfMostPathsWhereTheMeanSquareIsThatOfTheWorst) {
  constexpr int paths = 1000;
  const auto dt = halvings(8, 0.25);
  const auto e = errors_of(dt, paths, [&](int p, double h) { return p % 10 < 3 ? std::sqrt(h) : h; });
  const auto fit = fit_order(dt, e, 0, 1);
  ASSERT_TRUE(fit);
  EXPECT_LT(fit->high, 0.7);
  const auto slopes = fit_path_slopes(dt, e, *fit, 0.9);
  ASSERT_TRUE(slopes);
  EXPECT_NEAR(slopes->median.order, 1, 1e-12);
  EXPECT_NEAR(slopes->low, 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(slopes->share_at_least, 0.7);
}

TEST(PathSlopes, HoldTheMedianInNineteenOfTwentyIntervals) {
  constexpr int runs = 1000, paths = 101;
  const auto dt = halvings(4, 0.25);
  int held = 0;
  for (int run = 0; run < runs; ++run) {
    const auto e = errors_of(dt, paths, [&](int p, double h) {
      return std::pow(h, 1 + 0.2 * normal_at(static_cast<std::uint64_t>(run + 1), p));
    });
    const order_fit all{1, 1, 1, 1, std::vector<bool>(dt.size(), true), "", true, {}};
    const auto s = fit_path_slopes(dt, e, all, 1);
    held += s->median.low <= 1 && 1 <= s->median.high ? 1 : 0;
  }
  EXPECT_GT(held, 930);
  EXPECT_LT(held, 985);
}

// Slopes 1 + p / 10^4 for p = 1, 2, …, 10^4: 250 of them lie below the middle 95 %.
TEST(PathSlopes, SayInWhatRangeTheMiddleOfThemLies) {
  const auto dt = halvings(4, 0.25);
  const auto e = errors_of(dt, 10'000, [](int p, double h) { return std::pow(h, 1 + 1e-4 * (p + 1)); });
  const order_fit all{1, 1, 1, 1, std::vector<bool>(dt.size(), true), "", true, {}};
  const auto slopes = fit_path_slopes(dt, e, all, 1.5);
  ASSERT_TRUE(slopes);
  EXPECT_NEAR(slopes->low, 1.025, 1.01e-4);
  EXPECT_NEAR(slopes->high, 1.975, 1.01e-4);
  EXPECT_NEAR(slopes->median.order, 1.5, 1.01e-4);
  EXPECT_NEAR(slopes->share_at_least, 0.5, 2e-4);
}

TEST(PathSlopes, LeaveOutPathsThatHaveNone) {
  const auto dt = halvings(5, 0.25);
  const order_fit all{1, 1, 1, 1, std::vector<bool>(dt.size(), true), "", true, {}};
  const auto lost = errors_of(dt, 100, [](int p, double h) { return p < 50 ? NAN : p < 60 ? 0 : h; });
  EXPECT_NEAR(fit_path_slopes(dt, lost, all, 1)->median.order, 1, 1e-12);
  const auto few = errors_of(dt, 40, [](int p, double h) { return p < 30 ? NAN : h; });
  EXPECT_FALSE(fit_path_slopes(dt, few, all, 1));
}

// Of three levels of five, at steps 1/4, 1/8, 1/16: the slope of a path is that between their ends, and the 14th of
// forty slopes from either end are the interval of their median.
TEST(PathSlopes, AreSlopesBetweenTheEndsOfThreeLevels) {
  const auto dt = halvings(5, 0.25);
  const order_fit chosen{1, 1, 1, 1, {true, true, true, false, false}, "", true, {}};
  for (const int paths : {40, 41}) {
    const auto e = errors_of(dt, paths, [&](int p, double h) {
      const int place = (p * 17) % paths;  // in no order
      const double slope = 1 + place / 64.0;
      return 4 * std::pow(h, slope) * (h == 0.125 ? std::exp2(-0.25) : 1);  // less at the middle one
    });
    const auto found = fit_path_slopes(dt, e, chosen, 1 + 10 / 64.0);
    ASSERT_TRUE(found) << paths;
    const double median = 1 + (paths - 1) / 128.0;
    EXPECT_NEAR(found->median.order, median, 1e-13);
    EXPECT_NEAR(found->median.low, 1 + 13 / 64.0, 1e-13);
    EXPECT_NEAR(found->median.high, 1 + (paths - 14) / 64.0, 1e-13);
    EXPECT_NEAR(found->median.finest.value, median - 0.25, 1e-13);
    EXPECT_NEAR(found->median.prefactor, 4 * std::exp2(-0.25 / 3), 1e-12);
    EXPECT_NEAR(found->share_at_least, (paths - 10.0) / paths, 1.01 / paths);
  }
  const auto thirty_two = errors_of(dt, 32, [](int, double h) { return h; });
  EXPECT_TRUE(fit_path_slopes(dt, thirty_two, chosen, 1));
  EXPECT_EQ(fit_path_slopes(dt, thirty_two, chosen, 1)->share_at_least, 1);
}

// P(X <= 125) is 0.025008 for X heads of 284 coins: the 125th slope from either end. Steps that do not halve.
TEST(PathSlopes, RanksOfTheMedianAreTheBinomials) {
  constexpr int paths = 284, rank = 125;
  double term = std::exp2(-paths), sum = term;
  for (int k = 1; k < rank; ++k) sum += term *= (paths - k + 1.0) / k;
  ASSERT_LT(sum, 0.025);
  sum += term * (paths - rank + 1.0) / rank;
  ASSERT_GT(sum, 0.025);
  ASSERT_LT(sum, 0.02501);
  const std::vector<double> dt{0.25, 0.0625, 0.03125, 0.00390625};
  const auto e = errors_of(dt, paths, [](int p, double h) { return std::pow(h, 1 + ((p * 17) % paths) / 512.0); });
  const order_fit all{1, 1, 1, 1, std::vector<bool>(dt.size(), true), "", true, {}};
  const auto found = fit_path_slopes(dt, e, all, 1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->median.low, 1 + (rank - 1) / 512.0, 1e-13);
  EXPECT_NEAR(found->median.high, 1 + (paths - rank) / 512.0, 1e-13);
  EXPECT_NEAR(found->median.finest.value, 1 + (paths - 1) / 1024.0, 1e-13);
  EXPECT_NEAR(found->median.finest.low, 1 + (rank - 1) / 512.0, 1e-13);
}

}  // namespace
}  // namespace polhode
