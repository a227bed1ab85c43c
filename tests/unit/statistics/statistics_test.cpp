#include <gtest/gtest.h>

#include <cmath>

#include <polhode/noise/normal.hpp>

#include "experiments/common/judge.hpp"
#include "statistics/orders/finest_order.hpp"
#include "statistics/orders/order_fit.hpp"
#include "statistics/orders/power_series.hpp"
#include "statistics/sample.hpp"

namespace polhode {
namespace {

std::vector<double> halvings(int levels) {
  std::vector<double> dt;
  for (int i = 0; i < levels; ++i) dt.push_back(std::exp2(-3 - i));
  return dt;
}

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

squared_errors noisy_errors(const std::vector<double>& dt, double order, double offset, std::uint64_t seed, int paths) {
  squared_errors e{paths, static_cast<int>(dt.size()), {}};
  for (int path = 0; path < paths; ++path) {
    const auto z = normals<2>({seed, noise_kind::increment, static_cast<std::uint64_t>(path), 0});
    for (const double h : dt)
      e.values.push_back(std::pow(h, 2 * order) * (z[0] * z[0] + z[1] * z[1]) + offset * offset);
  }
  return e;
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

TEST(ErrorModel, TellsAWrongLimitFromARightOne) {
  const auto dt = halvings(6);
  const std::vector<bool> used(6, true);
  EXPECT_LT(fit_error_model(dt, noisy_errors(dt, 0.5, 0, 1, 500), used, 0.5, 1).limit.high, 0.02);
  const auto wrong = fit_error_model(dt, noisy_errors(dt, 0.5, 0.3, 1, 500), used, 0.5, 1).limit;
  EXPECT_GT(wrong.low, 0.25);
  EXPECT_NEAR(wrong.value, 0.3, 0.02);
}

// Order 1/2 hidden under a larger term of order 1: the slope does not show it, the leading coefficient does.
TEST(ErrorModel, FindsALeadingTermBelowALargerOne) {
  const auto dt = halvings(6);
  const std::vector<bool> used(6, true);
  squared_errors hidden = noisy_errors(dt, 1.0, 0, 1, 500), pure = hidden;
  for (int path = 0; path < hidden.paths; ++path)
    for (int l = 0; l < hidden.levels; ++l) hidden.at(path, l) += 0.02 * dt[static_cast<std::size_t>(l)];
  EXPECT_GT(fit_order(dt, hidden, 0, 1)->low, 0.6);
  EXPECT_NEAR(fit_error_model(dt, hidden, used, 0.5, 1).leading.value, 0.02, 2e-3);
  EXPECT_GT(fit_error_model(dt, hidden, used, 0.5, 1).leading.low, 0);
  EXPECT_LE(fit_error_model(dt, pure, used, 0.5, 1).leading.low, 1e-9);
}

// dt^2 under dt^4, and dt^4 alone: three powers tell them apart, two take the misfit for a negative leading term.
TEST(ErrorModel, ThreePowersFindATermFarBelowTheSlope) {
  const auto dt = halvings(6);
  const std::vector<bool> used(6, true);
  squared_errors with{500, 6, {}}, alone = with;
  for (int path = 0; path < 500; ++path) {
    const auto z = normals<2>({3, noise_kind::increment, static_cast<std::uint64_t>(path), 0});
    const double size = z[0] * z[0] + z[1] * z[1];
    for (const double h : dt) {
      with.values.push_back(size * (1e-5 * h * h + std::pow(h, 4)));
      alone.values.push_back(size * std::pow(h, 4));
    }
  }
  EXPECT_GT(fit_error_model(dt, with, used, 1, 1, 3).leading.low, 1.5e-5);
  EXPECT_LE(fit_error_model(dt, alone, used, 1, 1, 3).leading.low, 1e-12);
  EXPECT_LT(fit_error_model(dt, with, used, 1, 1, 2).leading.high, 0);
}

struct exact_levels {
  std::vector<double> dt, error, uncertainty;
};

/// Errors f(dt), known to a share of themselves.
template <class F>
exact_levels levels_of(int count, double share, const F& f) {
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
    const auto l = levels_of(count, 0, [](double h) { return 0.25 + 3 * h - 5 * h * h; });
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
    return levels_of(8, 1e-5, [limit](double h) { return limit + std::sin(3 * h) / (1 + h); });
  };
  const auto wrong = term_of(series(1e-5), 0), right = term_of(series(0), 0);
  EXPECT_GT(std::fabs(wrong.value), 2 * wrong.certainty());
  EXPECT_NEAR(wrong.value, 1e-5, wrong.certainty());
  EXPECT_LE(std::fabs(right.value), right.certainty());
}

// Order two claimed, and a term of order one below it.
TEST(ErrorExpansion, SeesALowerTermBelowTheClaimedOne) {
  const auto series = [](double lower) {
    return levels_of(8, 1e-5, [lower](double h) { return lower * h + h * h * std::exp(h); });
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
    auto l = levels_of(8, 1e-4,
                       [&](double h) { return z[0] * h + z[1] * h * h + w[0] * std::pow(h, 3) * std::exp(w[1] * h); });
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
  const auto l = levels_of(3, 0, [](double h) { return h; });
  EXPECT_TRUE(series_term_by_best_degree(l.dt, l.error, l.uncertainty, 0));
  EXPECT_FALSE(series_term_by_best_degree(l.dt, l.error, l.uncertainty, 1));
  auto lost = levels_of(4, 0, [](double h) { return h; });
  lost.error[1] = NAN;
  lost.error[2] = INFINITY;
  EXPECT_FALSE(series_term_by_best_degree(lost.dt, lost.error, lost.uncertainty, 0));
}

TEST(FinestOrder, SettlesOnThePowerAndItsIntervalHoldsIt) {
  const auto fit = finest_order(levels_of(8, 1e-6, [](double h) { return h + 2 * h * h; }));
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->settled);
  EXPECT_LE(fit->low, 1);
  EXPECT_GE(fit->high, 1);
  EXPECT_LT(half_width(*fit), 0.05);
}

// Bias of opposite sign: before the zero crossing the slope is steep, after it flat.
TEST(FinestOrder, HasNotSettledBesideAZeroCrossing) {
  const auto before = finest_order(levels_of(6, 1e-6, [](double h) { return h - 0.6 * std::exp2(-9); }));
  ASSERT_TRUE(before);
  EXPECT_GT(before->order, 1.2);
  EXPECT_FALSE(before->settled);
  EXPECT_EQ(judge_order(1, before, true).kind, report::verdict_kind::inconclusive);
}

TEST(FinestOrder, NeedsFourClearLevels) {
  EXPECT_FALSE(finest_order(levels_of(3, 0, [](double h) { return h; })));
  EXPECT_FALSE(finest_order(levels_of(8, 0.1, [](double h) { return h; })));
}

TEST(Judge, IntervalsDecide) {
  using enum report::verdict_kind;
  EXPECT_EQ(judge(1, 0.95, 1.05, 0.1), holds);
  EXPECT_EQ(judge(1, 0.85, 1.05, 0.1), inconclusive);
  EXPECT_EQ(judge(1, 0.4, 0.6, 0.1), refuted);
  EXPECT_EQ(judge(1, 1.2, 1.3, 0.1), refuted);
  EXPECT_EQ(judge(1, NAN, 1, 0.1), inconclusive);
}

TEST(Judge, FasterThanClaimedHoldsOnlyWhereTheClaimIsABound) {
  order_fit fit;
  fit.order = 3;
  fit.low = 2.98;
  fit.high = 3.02;
  fit.finest = {3, 2.98, 3.02};
  EXPECT_EQ(judge_order(2, fit, true).kind, report::verdict_kind::holds);
  EXPECT_EQ(judge_order(2, fit, false).kind, report::verdict_kind::refuted);
  EXPECT_EQ(judge_order(2, std::nullopt, true).kind, report::verdict_kind::inconclusive);
}

// Two powers that cross inside the levels, the slower one below: the slope there is that of neither.
TEST(Judge, ASlopeThatStillChangesRefutesNothing) {
  const auto dt = halvings(4);
  std::vector<double> crossing, straight;
  for (const double h : dt) {
    crossing.push_back(h + 20 * h * h);
    straight.push_back(std::pow(h, 1.5));
  }
  const auto bent = fit_order(dt, crossing, 0), line = fit_order(dt, straight, 0);
  EXPECT_FALSE(bent->settled);
  EXPECT_TRUE(line->settled);
  auto refuting = *bent;
  refuting.low = 1.4;
  refuting.high = 1.6;
  EXPECT_EQ(judge_order(1, refuting, false).kind, report::verdict_kind::inconclusive);
  EXPECT_EQ(judge_order(1, line, false).kind, report::verdict_kind::refuted);
  refuting = *line;
  refuting.finest = {1.15, 1.05, 1.25};
  EXPECT_EQ(judge_order(1, refuting, false).kind, report::verdict_kind::inconclusive);
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
  EXPECT_FALSE(fit_order(dt, bent, 0, 1)->settled);
  EXPECT_TRUE(fit_order(dt, straight, 0, 1)->settled);
}

TEST(KolmogorovSmirnov, DistanceOfASmallSampleByHand) {
  const std::vector<double> x{0.1, 0.4, 0.9};
  EXPECT_NEAR(ks_distance(x, [](double t) { return t; }).value, 2.0 / 3 - 0.4, 1e-15);
}

}  // namespace
}  // namespace polhode
