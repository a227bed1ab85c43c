// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/power_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <polhode/noise/normal.hpp>

namespace polhode {
namespace {

const std::vector<double> binary_dt{0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0078125};

std::vector<interval_estimate> first(const std::function<double(double)>& f, double uncertainty, std::size_t count) {
  std::vector<double> value, u(binary_dt.size(), uncertainty);
  for (const double h : binary_dt) value.push_back(f(h));
  return series_by_all_levels(binary_dt, value, u, count);
}

TEST(PowerSeries, PolynomialsAreFoundToRounding) {
  const auto c = first([](double h) { return 2 - 3 * h + 5 * h * h * h; }, 0, 3);
  EXPECT_NEAR(c[0].value, 2, 1e-13);
  EXPECT_NEAR(c[1].value, -3, 1e-10);
  EXPECT_NEAR(c[2].value, 0, 1e-8);
}

TEST(PowerSeries, IntervalsHoldTheTruth) {
  for (const double a : {0.1, 0.7, 2.0, -3.0}) {
    const auto c = first([&](double h) { return std::exp(a * h) / (1 + h); }, 1e-14, 3);
    const double truth[] = {1, a - 1, a * a / 2 - a + 1};
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_LE(c[j].low, truth[j]);
      EXPECT_GE(c[j].high, truth[j]);
      EXPECT_LT(c[j].high - c[j].low, 0.05) << j;
    }
  }
}

TEST(PowerSeries, UncertainValuesWidenIntervals) {
  const auto sure = first([](double h) { return h; }, 0, 2), unsure = first([](double h) { return h; }, 1e-6, 2);
  EXPECT_GT(unsure[0].high - unsure[0].low, 2e-6);
  EXPECT_LT(sure[0].high - sure[0].low, 1e-12);
}

TEST(PowerSeries, RefusesTooFewLevels) {
  const std::vector<double> three{0.5, 0.25, 0.125};
  EXPECT_THROW(series_by_all_levels(three, three, three, 2), std::invalid_argument);
  EXPECT_EQ(series_by_all_levels(three, three, three, 1).size(), 1u);
}

/// How two rules fare on the same random series c_k = N(0, 1) growth^k, for c_0 and c_1.
struct trial {
  int all_levels = 0, best_degree = 0, narrower = 0;  ///< misses of either; how often all levels are narrower
};

trial try_rules(int levels, double growth, double share) {
  trial out;
  std::vector<double> steps;
  for (int i = 0; i < levels; ++i) steps.push_back(std::ldexp(0.25, -i));
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto c = normals<14>({seed, noise_kind::increment, 1, 0});
    const auto sign = normals<9>({seed, noise_kind::area, 1, 0});
    std::vector<double> value, u;
    for (const double h : steps) {
      double sum = 0;
      for (int k = 14; k-- > 0;) sum = c[k] + growth * h * sum;
      u.push_back(share * std::fabs(sum) + 1e-15);
      value.push_back(sum + (sign[static_cast<int>(u.size()) - 1] > 0 ? 1 : -1) * share * std::fabs(sum));
    }
    const auto all = series_by_all_levels(steps, value, u, 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const double truth = k == 0 ? c[0] : growth * c[1];
      const auto best = *series_term_by_best_degree(steps, value, u, static_cast<int>(k));
      out.all_levels += truth < all[k].low || truth > all[k].high;
      out.best_degree += std::fabs(truth - best.value) > best.certainty();
      out.narrower += (all[k].high - all[k].low) / 2 < best.certainty();
    }
  }
  return out;
}

// Of 400 coefficients each.
TEST(PowerSeries, EachRuleIsTheBetterOneOnItsOwnGround) {
  const auto exact = try_rules(6, 1, 0), rough = try_rules(9, 1, 1e-4), steep = try_rules(6, 4, 0);
  EXPECT_LE(exact.all_levels, 4);
  EXPECT_GE(exact.narrower, 350);
  EXPECT_EQ(rough.best_degree, 0);
  EXPECT_LT(rough.narrower, 200);
  EXPECT_LE(steep.best_degree, 6);
  EXPECT_GE(steep.all_levels, 2 * steep.best_degree);
}

// What the coarsest adds is taken away wherever it stands.
TEST(PowerSeries, LevelsComeInAnyOrder) {
  const auto f = [](double h) { return std::exp(2 * h) / (1 + h); };
  const auto sorted = first(f, 1e-9, 3);
  for (const auto& steps : {std::vector{0.0078125, 0.015625, 0.03125, 0.0625, 0.125, 0.25},
                            std::vector{0.0625, 0.125, 0.25, 0.0078125, 0.03125, 0.015625}}) {
    std::vector<double> value;
    for (const double h : steps) value.push_back(f(h));
    const auto found = series_by_all_levels(steps, value, std::vector<double>(6, 1e-9), 3);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(found[j].value, sorted[j].value, 1e-9);
      EXPECT_NEAR(found[j].low, sorted[j].low, 1e-9);
      EXPECT_NEAR(found[j].high, sorted[j].high, 1e-9);
    }
  }
}

// One level is uncertain, of zeros: its Lagrange polynomial at zero.
TEST(PowerSeries, EveryLevelsUncertaintyCounts) {
  const std::vector<double> zeros(binary_dt.size(), 0.0);
  for (std::size_t i = 0; i < binary_dt.size(); ++i) {
    double weight = 1;
    for (std::size_t k = 0; k < binary_dt.size(); ++k)
      if (k != i) weight *= binary_dt[k] / std::fabs(binary_dt[i] - binary_dt[k]);
    auto uncertainty = zeros;
    uncertainty[i] = 0.5;
    EXPECT_NEAR(series_by_all_levels(binary_dt, zeros, uncertainty, 1)[0].high / (0.5 * weight), 1, 1e-12) << i;
  }
}

// A polynomial of degree seven: one of degree eight changes nothing more, and degree nine is not tried. Of zeros, which
// all degrees find, the lowest.
TEST(PowerSeries, BestDegreeIsEightAtMostAndTheLowestOfEqualOnes) {
  std::vector<double> steps, value;
  for (int i = 11; i > 0; --i) steps.push_back(i / 16.0);
  const std::vector<double> zeros(steps.size(), 0.0);
  for (const double h : steps) value.push_back((1 - std::pow(h, 8)) / (1 - h));
  const auto found = series_term_by_best_degree(steps, value, zeros, 1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->degree, 8);
  EXPECT_NEAR(found->value, 1, 1e-9);
  for (const int k : {0, 1, 2}) EXPECT_EQ(series_term_by_best_degree(steps, zeros, zeros, k)->degree, k + 1) << k;
}

// Levels 1, 1/2, 1/4: their Lagrange polynomials at zero are 1/3, -2, 8/3, of the finer two -1 and 2.
TEST(PowerSeries, IsAsUncertainAsThreeNextTermsOrAnEighthOfTheOneBefore) {
  const std::vector<double> three{1, 0.5, 0.25}, none(3, 0.0);
  const auto half = [&](const std::vector<double>& value) {
    const auto found = series_by_all_levels(three, value, none, 1)[0];
    return (found.high - found.low) / 2;
  };
  EXPECT_NEAR(half({0.3, 0, 0}), 3 * 0.1, 1e-15);
  EXPECT_NEAR(half({0.6, 0.2, 0}), 3 * 0.2 / 8, 1e-15);  // the last change is none, the one before -0.2
}

TEST(PowerSeries, NoDegreeBeyondEightIsTried) {
  std::vector<double> steps, value;
  for (int i = 11; i > 0; --i) steps.push_back(i / 8.0);
  for (const double h : steps) value.push_back(2 + std::pow(h, 8));
  const auto found = series_term_by_best_degree(steps, value, std::vector<double>(steps.size(), 0.0), 0);
  ASSERT_TRUE(found);
  EXPECT_LE(found->degree, 8);
}

}  // namespace
}  // namespace polhode
