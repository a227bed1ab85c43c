#include "statistics/power_series.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace polhode {
namespace {

const std::vector<double> dt{0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0078125};

std::vector<interval_estimate> first(const std::function<double(double)>& f, double uncertainty, std::size_t count) {
  std::vector<double> value, u(dt.size(), uncertainty);
  for (const double h : dt) value.push_back(f(h));
  return series_coefficients(dt, value, u, count);
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
  EXPECT_THROW(series_coefficients(three, three, three, 2), std::invalid_argument);
}

}  // namespace
}  // namespace polhode
