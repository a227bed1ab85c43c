#include "statistics/error_expansion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr int most_degree = 8;
constexpr std::size_t fit_levels = 4;
constexpr double changes = 1.5, settled_change = 0.05;

struct level {
  double dt, error, uncertainty;
};

/// From fine to coarse.
std::vector<level> finite_levels(std::span<const double> dt, std::span<const double> error,
                                 std::span<const double> uncertainty) {
  std::vector<level> out;
  for (std::size_t i = dt.size(); i-- > 0;)
    if (std::isfinite(error[i]) && std::isfinite(uncertainty[i])) out.push_back({dt[i], error[i], uncertainty[i]});
  return out;
}

struct value_and_error {
  double value, propagated;
};

/// The k-th coefficient of the Lagrange polynomial that is one at level i: of prod (x - x_j) / (x_i - x_j), j != i. The
/// x are positive, so the terms of each coefficient have one sign and nothing cancels.
double lagrange_coefficient(std::span<const level> levels, std::size_t i, int k) {
  std::vector<double> product{1};
  for (std::size_t j = 0; j < levels.size(); ++j) {
    if (j == i) continue;
    const double difference = levels[i].dt - levels[j].dt;
    product.insert(product.begin(), 0);  // times x
    for (std::size_t m = 0; m + 1 < product.size(); ++m) product[m] -= levels[j].dt * product[m + 1];
    for (double& c : product) c /= difference;
  }
  return product[static_cast<std::size_t>(k)];
}

/// The k-th coefficient of the polynomial through all of the levels.
value_and_error interpolated(std::span<const level> levels, int k) {
  value_and_error out{0, 0};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double weight = lagrange_coefficient(levels, i, k);
    out.value += weight * levels[i].error;
    out.propagated += std::fabs(weight) * levels[i].uncertainty;
  }
  return out;
}

expansion_term term_of_degree(std::span<const level> levels, int k, std::size_t degree) {
  const auto [value, propagated] = interpolated(levels.first(degree + 1), k);
  const double lower = interpolated(levels.first(degree), k).value,
               coarser = interpolated(levels.subspan(1, degree + 1), k).value;
  return {value, propagated, std::max(std::fabs(value - lower), std::fabs(value - coarser)), static_cast<int>(degree)};
}

double slope(const level& fine, const level& coarse) {
  return std::log(std::fabs(coarse.error / fine.error)) / std::log(coarse.dt / fine.dt);
}

double slope_uncertainty(const level& fine, const level& coarse) {
  return (fine.uncertainty / std::fabs(fine.error) + coarse.uncertainty / std::fabs(coarse.error)) /
         std::log(coarse.dt / fine.dt);
}

}  // namespace

std::optional<expansion_term> expansion_coefficient(std::span<const double> dt, std::span<const double> error,
                                                    std::span<const double> uncertainty, int k) {
  const auto levels = finite_levels(dt, error, uncertainty);
  std::optional<expansion_term> best;
  const auto least = static_cast<std::size_t>(k) + 1;
  for (std::size_t degree = least; degree <= most_degree && degree + 2 <= levels.size(); ++degree) {
    const auto term = term_of_degree(levels, k, degree);
    if (!best || term.certainty() < best->certainty()) best = term;
  }
  return best;
}

std::optional<order_fit> fit_finest_order(std::span<const double> dt, std::span<const double> error,
                                          std::span<const double> uncertainty, double clear) {
  std::vector<level> levels;
  order_fit fit;
  fit.used.assign(dt.size(), false);
  for (std::size_t i = dt.size(); i-- > 0 && levels.size() < fit_levels;) {
    const double size = std::fabs(error[i]);
    fit.used[i] = std::isfinite(size) && size > 0 && size >= clear * uncertainty[i];
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
  fit.settled = change <= settled_change;
  fit.finest = {last, fit.low, fit.high};
  return fit;
}

}  // namespace polhode
