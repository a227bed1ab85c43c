// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/path_slopes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics/distributions.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

constexpr std::size_t least_paths = 32;

/// Median with the interval between order statistics of binomial rank: of both sides fewer than so many lie outside the
/// median with probability 0.025 at most. At least six values.
interval_estimate median_of(std::vector<double> values) {
  std::ranges::sort(values);
  const auto n = values.size();
  const auto below = static_cast<std::size_t>(binomial_quantile(0.025, static_cast<double>(n), 0.5));
  return {(values[(n - 1) / 2] + values[n / 2]) / 2, values[below - 1], values[n - below]};
}

/// Weights of the values at these abscissae in the slope of the least-squares line.
std::vector<double> slope_weights(const std::vector<double>& x) {
  double mean = 0, square = 0;
  for (const double a : x) mean += a / static_cast<double>(x.size());
  for (const double a : x) square += (a - mean) * (a - mean);
  std::vector<double> out;
  for (const double a : x) out.push_back((a - mean) / square);
  return out;
}

}  // namespace

std::optional<path_slopes> fit_path_slopes(std::span<const double> dt, const squared_errors& e, const order_fit& chosen,
                                           double asked) {
  std::vector<int> levels;
  std::vector<double> x;
  for (std::size_t l = 0; l < dt.size(); ++l)
    if (chosen.used[l]) {
      levels.push_back(static_cast<int>(l));
      x.push_back(std::log2(dt[l]));
    }
  const auto weights = slope_weights(x);
  const std::size_t n = x.size();
  double middle = 0;
  for (const double a : x) middle += a / static_cast<double>(n);
  std::vector<double> slopes, finest, sizes;
  for (int path = 0; path < e.paths; ++path) {
    double slope = 0, size = 0, before = 0, last = 0;
    for (std::size_t k = 0; k < n; ++k) {
      before = last;
      last = 0.5 * std::log2(e.at(path, levels[k]));
      slope += weights[k] * last;
      size += last / static_cast<double>(n);
    }
    if (!std::isfinite(slope)) continue;
    slopes.push_back(slope);
    finest.push_back((last - before) / (x[n - 1] - x[n - 2]));
    sizes.push_back(size);
  }
  if (slopes.size() < least_paths) return std::nullopt;
  const auto m = median_of(slopes);
  const auto [low, high] = central_interval(slopes, 0.95);
  const auto enough = std::ranges::count_if(slopes, [&](double s) { return s >= asked; });
  const double factor = std::exp2(median_of(sizes).value - m.value * middle);
  path_slopes out{{m.value, m.low, m.high, factor, chosen.used,
                   fmt::format("median of the slopes of {} single paths over {} levels; the middle 95 % of them lie in "
                               "[{:.2f}, {:.2f}]",
                               slopes.size(), n, low, high),
                   chosen.asymptotic, median_of(finest)},
                  low,
                  high,
                  static_cast<double>(enough) / static_cast<double>(slopes.size())};
  return out;
}

}  // namespace polhode
