// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/finest_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace polhode {
namespace {

constexpr std::size_t fit_levels = 4;
constexpr double changes = 1.5, asymptotic_change = 0.05;

struct clear_level {
  double dt, error, uncertainty;
};

double slope(const clear_level& fine, const clear_level& coarse) {
  return std::log(std::fabs(coarse.error / fine.error)) / std::log(coarse.dt / fine.dt);
}

double slope_uncertainty(const clear_level& fine, const clear_level& coarse) {
  return (fine.uncertainty / std::fabs(fine.error) + coarse.uncertainty / std::fabs(coarse.error)) /
         std::log(coarse.dt / fine.dt);
}

}  // namespace

std::optional<order_fit> fit_finest_order(std::span<const double> dt, std::span<const double> error,
                                          std::span<const double> uncertainty, double resolved) {
  std::vector<clear_level> levels;
  order_fit fit;
  fit.used.assign(dt.size(), false);
  for (std::size_t i = dt.size(); i-- > 0 && levels.size() < fit_levels;) {
    const double size = std::fabs(error[i]);
    fit.used[i] = std::isfinite(size) && size > 0 && size >= resolved * uncertainty[i];
    if (fit.used[i]) levels.push_back({dt[i], error[i], uncertainty[i]});
  }
  if (levels.size() < fit_levels) return std::nullopt;
  const double last = slope(levels[0], levels[1]), before = slope(levels[1], levels[2]),
               first = slope(levels[2], levels[3]);
  const double change = changes * std::max(std::fabs(last - before), std::fabs(before - first) / 2);
  const double half = change + slope_uncertainty(levels[0], levels[1]);
  fit.order = last;
  fit.low = last - half;
  fit.high = last + half;
  fit.prefactor = std::fabs(levels[0].error) / std::pow(levels[0].dt, last);
  fit.rule = fmt::format(
      "slope between the two finest levels that are clear; its interval from what it changed by over four of them, of "
      "{}",
      dt.size());
  fit.asymptotic = change <= asymptotic_change;
  fit.finest = {last, fit.low, fit.high};
  return fit;
}

}  // namespace polhode
