// SPDX-License-Identifier: Apache-2.0
#include "statistics/sample.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "statistics/distributions.hpp"

namespace polhode {

interval_estimate mean_interval(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0, square = 0;
  for (const double v : values) mean += v / n;
  for (const double v : values) square += (v - mean) * (v - mean);
  const double half = student_t_quantile(0.975, n - 1) * std::sqrt(square / (n - 1) / n);
  return {mean, mean - half, mean + half};
}

interval_estimate ks_distance(std::span<const double> values, const std::function<double(double)>& cdf, double worth) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const auto n = static_cast<double>(sorted.size());
  double distance = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double f = cdf(sorted[i]);
    distance = std::max({distance, f - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - f});
  }
  const double half = std::sqrt(std::log(2 / 0.05) / (2 * (worth > 0 ? worth : n)));
  return {distance, std::max(0.0, distance - half), distance + half};
}

}  // namespace polhode
