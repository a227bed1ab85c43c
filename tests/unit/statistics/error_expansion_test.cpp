// SPDX-License-Identifier: Apache-2.0
// Errors known to a share of themselves: the terms of their expansion, and the order at the finest steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <polhode/noise/normal.hpp>

#include "experiments/common/judge.hpp"
#include "statistics/orders/finest_order.hpp"
#include "statistics/orders/power_series.hpp"
#include "support/halvings.hpp"

namespace polhode {
namespace {

using test::halvings;

struct exact_levels {
  std::vector<double> dt, error, uncertainty;
};

/// Errors f(dt), known to a share of themselves.
template <class F>
exact_levels halved_levels(int count, double share, const F& f) {
  exact_levels out{halvings(count), {}, {}};
  for (const double h : out.dt) {
    out.error.push_back(f(h));
    out.uncertainty.push_back(share * std::fabs(out.error.back()) + 1e-16);
  }
  return out;
}

expansion_term term_of(const exact_levels& l, int k) {
  return *series_term_by_best_degree(l.dt, l.error, l.uncertainty, k);
}

std::optional<order_fit> finest_order(const exact_levels& l) {
  return fit_finest_order(l.dt, l.error, l.uncertainty, 50);
}

TEST(ErrorExpansion, FindsEveryTermOfAPolynomial) {
  for (const int count : {6, 9, 16}) {
    const auto l = halved_levels(count, 0, [](double h) { return 0.25 + 3 * h - 5 * h * h; });
    for (const auto& [k, value] : {std::pair{0, 0.25}, {1, 3.0}, {2, -5.0}}) {
      const auto term = term_of(l, k);
      EXPECT_NEAR(term.value, value, term.certainty() + 1e-9) << count << ' ' << k;
      EXPECT_LT(term.certainty(), 1e-4) << count << ' ' << k;
    }
  }
}

// A limit a thousand times below the finest error, and one that is zero.
TEST(ErrorExpansion, SeesALimitFarBelowTheErrors) {
  const auto series = [](double limit) {
    return halved_levels(8, 1e-5, [limit](double h) { return limit + std::sin(3 * h) / (1 + h); });
  };
  const auto wrong = term_of(series(1e-5), 0), right = term_of(series(0), 0);
  EXPECT_GT(std::fabs(wrong.value), 2 * wrong.certainty());
  EXPECT_NEAR(wrong.value, 1e-5, wrong.certainty());
  EXPECT_LE(std::fabs(right.value), right.certainty());
}

// Order two claimed, and a term of order one below it.
TEST(ErrorExpansion, SeesALowerTermBelowTheClaimedOne) {
  const auto series = [](double lower) {
    return halved_levels(8, 1e-5, [lower](double h) { return lower * h + h * h * std::exp(h); });
  };
  const auto hidden = term_of(series(1e-4), 1), none = term_of(series(0), 1);
  EXPECT_NEAR(hidden.value, 1e-4, hidden.certainty());
  EXPECT_GT(hidden.value, 2 * hidden.certainty());
  EXPECT_LE(std::fabs(none.value), none.certainty());
}

// Its promise, tested as such: series of many kinds, levels off by as much as their uncertainty allows.
TEST(ErrorExpansion, IsAsCertainAsItSays) {
  int covered = 0;
  double widest = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const auto z = normals<2>({seed, noise_kind::increment, 1, 0});
    const auto w = normals<2>({seed, noise_kind::increment, 2, 0});
    auto l = halved_levels(
        8, 1e-4, [&](double h) { return z[0] * h + z[1] * h * h + w[0] * std::pow(h, 3) * std::exp(w[1] * h); });
    for (std::size_t i = 0; i < l.dt.size(); ++i)
      l.error[i] += l.uncertainty[i] * (normals<1>({seed, noise_kind::area, 3, i})[0] > 0 ? 1 : -1);
    const auto limit = term_of(l, 0), slope = term_of(l, 1);
    covered += std::fabs(limit.value) <= limit.certainty() && std::fabs(slope.value - z[0]) <= slope.certainty();
    widest = std::max(widest, limit.certainty());
  }
  EXPECT_EQ(covered, 500);
  EXPECT_LT(widest, 1e-4);
}

TEST(ErrorExpansion, AsksForEnoughLevels) {
  const auto l = halved_levels(3, 0, [](double h) { return h; });
  EXPECT_TRUE(series_term_by_best_degree(l.dt, l.error, l.uncertainty, 0));
  EXPECT_FALSE(series_term_by_best_degree(l.dt, l.error, l.uncertainty, 1));
  auto lost = halved_levels(4, 0, [](double h) { return h; });
  lost.error[1] = NAN;
  lost.error[2] = INFINITY;
  EXPECT_FALSE(series_term_by_best_degree(lost.dt, lost.error, lost.uncertainty, 0));
}

TEST(FinestOrder, SettlesOnThePowerAndItsIntervalHoldsIt) {
  const auto fit = finest_order(halved_levels(8, 1e-6, [](double h) { return h + 2 * h * h; }));
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->asymptotic);
  EXPECT_LE(fit->low, 1);
  EXPECT_GE(fit->high, 1);
  EXPECT_LT(half_width(*fit), 0.05);
}

// Bias of opposite sign: before the zero crossing the slope is steep, after it flat.
TEST(FinestOrder, HasNotSettledBesideAZeroCrossing) {
  const auto before = finest_order(halved_levels(6, 1e-6, [](double h) { return h - 0.6 * std::exp2(-9); }));
  ASSERT_TRUE(before);
  EXPECT_GT(before->order, 1.2);
  EXPECT_FALSE(before->asymptotic);
  EXPECT_EQ(judge_order(1, before, true).kind, report::verdict_kind::inconclusive);
}

TEST(FinestOrder, NeedsFourClearLevels) {
  EXPECT_FALSE(finest_order(halved_levels(3, 0, [](double h) { return h; })));
  EXPECT_FALSE(finest_order(halved_levels(8, 0.1, [](double h) { return h; })));
}

// Slopes 1, 1.1 and 1.5 from the finest pair on: the interval reaches 1.5 times half the change before the last.
TEST(FinestOrder, ReachesAsFarAsItsSlopesChanged) {
  const std::vector<double> dt{0.5, 0.25, 0.125, 0.0625, 0.03125};
  const auto with_slopes = [&](double last, double before, double first) {
    std::vector<double> error(5, 9.0);
    error[4] = -0.25;
    error[3] = error[4] * std::exp2(last);
    error[2] = error[3] * std::exp2(before);
    error[1] = error[2] * std::exp2(first);
    return error;
  };
  const std::vector<double> sure(5, 0.0), unsure{0, 0, 0, 0.002, 0.001};
  const auto fit = *fit_finest_order(dt, with_slopes(1, 1.1, 1.5), sure, 50);
  EXPECT_NEAR(fit.order, 1, 1e-14);
  EXPECT_NEAR(fit.low, 0.7, 1e-14);
  EXPECT_NEAR(fit.high, 1.3, 1e-14);
  EXPECT_NEAR(fit.prefactor, 0.25 / 0.03125, 1e-13);
  EXPECT_FALSE(fit.asymptotic);
  EXPECT_EQ(fit.used, (std::vector{false, true, true, true, true}));
  EXPECT_EQ(fit.finest.low, fit.low);
  const auto steady = *fit_finest_order(dt, with_slopes(2, 2.02, 2.02), unsure, 50);
  const double half = 1.5 * 0.02 + (0.001 / 0.25 + 0.002 / 1) / std::log(2);
  EXPECT_NEAR(steady.low, 2 - half, 1e-14);
  EXPECT_NEAR(steady.high, 2 + half, 1e-14);
  EXPECT_NEAR(steady.prefactor, 0.25 * 32 * 32, 1e-11);
  EXPECT_TRUE(steady.asymptotic);
  EXPECT_FALSE(fit_finest_order(dt, with_slopes(2, 2.034, 2.034), sure, 50)->asymptotic);
}

TEST(FinestOrder, OfLevelsThatAreClear) {
  const std::vector<double> dt{0.5, 0.25, 0.125, 0.0625, 0.03125};
  std::vector<double> error{0.5, 0.25, 0.125, 0.0625, 0.03125}, uncertainty(5, 1e-4);
  uncertainty[3] = 0.0625 / 49;
  const auto fit = *fit_finest_order(dt, error, uncertainty, 50);
  EXPECT_EQ(fit.used, (std::vector{true, true, true, false, true}));
  EXPECT_NEAR(fit.order, 1, 1e-14);
  uncertainty[3] = 0.0625 / 50;
  EXPECT_TRUE(fit_finest_order(dt, error, uncertainty, 50)->used[3]);
  uncertainty[3] = 0.0625 / 49;
  for (const double unclear : {0.0, HUGE_VAL, double{NAN}}) {
    error[0] = unclear;
    EXPECT_FALSE(fit_finest_order(dt, error, uncertainty, 50)) << unclear;
  }
}

// An error of zero that is known exactly has no logarithm.
TEST(FinestOrder, AnErrorOfZeroIsNoLevel) {
  const std::vector<double> dt{0.5, 0.25, 0.125, 0.0625, 0.03125}, error{0.5, 0.25, 0, 0.0625, 0.03125}, sure(5, 0.0);
  const auto fit = fit_finest_order(dt, error, sure, 50);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->used, (std::vector{true, true, false, true, true}));
  EXPECT_NEAR(fit->order, 1, 1e-14);
}

// Slopes of 1 + d, 1 + d and 1: by 1.5 d they changed, which settles up to 0.05. Each level has its own uncertainty.
TEST(FinestOrder, SettlesWhereItsSlopesChangedByATwentiethAtMost) {
  const std::vector<double> dt{0.5, 0.25, 0.125, 0.0625};
  for (const double d : {0.03332, 0.03335}) {
    const std::vector<double> error{0.3 * std::exp2(3 + 2 * d), 0.3 * std::exp2(2 + d), 0.6, 0.3};
    const std::vector<double> sure{0, 0, 3e-4 * error[2], 2e-4 * error[3]};
    const auto fit = fit_finest_order(dt, error, sure, 50);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->order, 1, 1e-13);
    EXPECT_NEAR(fit->high - fit->order, 1.5 * d + 5e-4 / std::log(2.0), 1e-12);
    EXPECT_EQ(fit->asymptotic, d < 0.05 / 1.5);
  }
}

}  // namespace
}  // namespace polhode
