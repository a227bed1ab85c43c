// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/power_series.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

constexpr double next_terms = 3;  // times the term that is seen
constexpr double accident = 8;    // a next term that happens to vanish is taken for that part of the one before
constexpr int most_degree = 8;

/// weights(j, i): what the value at dt_i adds to c_j scale^j. A Vandermonde matrix in dt / scale of a few levels is
/// inverted to rounding by Lagrange's polynomials: dt is positive, so the terms of each coefficient have one sign and
/// nothing cancels.
Eigen::MatrixXd coefficient_weights(std::span<const double> dt, double scale) {
  const auto n = static_cast<Eigen::Index>(dt.size());
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::VectorXd polynomial = Eigen::VectorXd::Unit(n, 0);
    const double x = dt[static_cast<std::size_t>(i)] / scale;
    for (Eigen::Index k = 0; k < n; ++k) {
      if (k == i) continue;
      const double root = dt[static_cast<std::size_t>(k)] / scale;
      Eigen::VectorXd shifted = Eigen::VectorXd::Zero(n);
      shifted.tail(n - 1) = polynomial.head(n - 1);
      polynomial = (shifted - root * polynomial) / (x - root);
    }
    weights.col(i) = polynomial;
  }
  return weights;
}

struct level_values {
  std::vector<double> dt, value;

  level_values without_coarsest() const {
    auto rest = *this;
    const auto coarsest = std::ranges::max_element(dt) - dt.begin();
    rest.dt.erase(rest.dt.begin() + coarsest);
    rest.value.erase(rest.value.begin() + coarsest);
    return rest;
  }
  /// Coefficients times powers of the scale.
  Eigen::VectorXd series(double scale) const {
    return coefficient_weights(dt, scale) *
           Eigen::Map<const Eigen::VectorXd>(value.data(), static_cast<Eigen::Index>(value.size()));
  }
};

struct known_level {
  double dt, error, uncertainty;
};

/// From fine to coarse.
std::vector<known_level> known_levels(std::span<const double> dt, std::span<const double> error,
                                      std::span<const double> uncertainty) {
  std::vector<known_level> out;
  for (std::size_t i = dt.size(); i-- > 0;)
    if (std::isfinite(error[i]) && std::isfinite(uncertainty[i])) out.push_back({dt[i], error[i], uncertainty[i]});
  return out;
}

struct value_and_error {
  double value, propagated;
};

/// The k-th coefficient of the polynomial through all of the levels.
value_and_error interpolated(std::span<const known_level> levels, int k) {
  value_and_error out{0, 0};
  std::vector<double> dt;
  for (const auto& l : levels) dt.push_back(l.dt);
  const auto weights = coefficient_weights(dt, 1);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double weight = weights(k, static_cast<Eigen::Index>(i));
    out.value += weight * levels[i].error;
    out.propagated += std::fabs(weight) * levels[i].uncertainty;
  }
  return out;
}

expansion_term term_of_degree(std::span<const known_level> levels, int k, std::size_t degree) {
  const auto [value, propagated] = interpolated(levels.first(degree + 1), k);
  const double lower = interpolated(levels.first(degree), k).value,
               coarser = interpolated(levels.subspan(1, degree + 1), k).value;
  return {value, propagated, std::max(std::fabs(value - lower), std::fabs(value - coarser)), static_cast<int>(degree)};
}

}  // namespace

std::vector<interval_estimate> series_by_all_levels(std::span<const double> dt, std::span<const double> value,
                                                    std::span<const double> uncertainty, std::size_t count) {
  if (dt.size() < count + 2) throw std::invalid_argument("series_by_all_levels: too few levels");
  const double scale = std::ranges::max(dt);
  const level_values all{{dt.begin(), dt.end()}, {value.begin(), value.end()}};
  const auto fewer = all.without_coarsest(), fewest = fewer.without_coarsest();
  const auto weights = coefficient_weights(all.dt, scale);
  const Eigen::VectorXd best = all.series(scale), second = fewer.series(scale), third = fewest.series(scale);
  std::vector<interval_estimate> out;
  for (std::size_t j = 0; j < count; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    double noise = 0;
    for (std::size_t i = 0; i < dt.size(); ++i)
      noise += std::fabs(weights(row, static_cast<Eigen::Index>(i))) * uncertainty[i];
    const double last = std::fabs(best[row] - second[row]), before = std::fabs(second[row] - third[row]);
    const double unit = std::pow(scale, static_cast<double>(j));
    const double half = (next_terms * std::max(last, before / accident) + noise) / unit;
    out.push_back({best[row] / unit, best[row] / unit - half, best[row] / unit + half});
  }
  return out;
}

std::optional<expansion_term> series_term_by_best_degree(std::span<const double> dt, std::span<const double> error,
                                                         std::span<const double> uncertainty, int k) {
  const auto levels = known_levels(dt, error, uncertainty);
  std::optional<expansion_term> best;
  const auto least = static_cast<std::size_t>(k) + 1;
  for (std::size_t degree = least; degree <= most_degree && degree + 2 <= levels.size(); ++degree) {
    const auto term = term_of_degree(levels, k, degree);
    if (!best || term.certainty() < best->certainty()) best = term;
  }
  return best;
}

}  // namespace polhode
