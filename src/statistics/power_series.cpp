#include "statistics/power_series.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

constexpr double next_terms = 3;  // times the term that is seen
constexpr double accident = 8;    // a next term that happens to vanish is taken for that part of the one before

/// weights(j, i): what the value at dt_i adds to c_j scale^j. A Vandermonde matrix in dt / scale of a few levels is
/// inverted to rounding by Lagrange's polynomials.
Eigen::MatrixXd weights_of(std::span<const double> dt, double scale) {
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
    return weights_of(dt, scale) *
           Eigen::Map<const Eigen::VectorXd>(value.data(), static_cast<Eigen::Index>(value.size()));
  }
};

}  // namespace

std::vector<interval_estimate> series_coefficients(std::span<const double> dt, std::span<const double> value,
                                                   std::span<const double> uncertainty, std::size_t count) {
  if (dt.size() < count + 2) throw std::invalid_argument("series_coefficients: too few levels");
  const double scale = std::ranges::max(dt);
  const level_values all{{dt.begin(), dt.end()}, {value.begin(), value.end()}};
  const auto fewer = all.without_coarsest(), fewest = fewer.without_coarsest();
  const auto weights = weights_of(all.dt, scale);
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

}  // namespace polhode
