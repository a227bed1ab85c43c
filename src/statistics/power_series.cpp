#include "statistics/power_series.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polhode {
namespace {

constexpr double next_terms = 3;  // times the term that is seen

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

}  // namespace

std::vector<interval_estimate> series_coefficients(std::span<const double> dt, std::span<const double> value,
                                                   std::span<const double> uncertainty, std::size_t count) {
  if (dt.size() < count + 2) throw std::invalid_argument("series_coefficients: too few levels");
  const auto coarsest = static_cast<std::size_t>(std::ranges::max_element(dt) - dt.begin());
  const auto without = [&](std::span<const double> all) {
    std::vector<double> rest(all.begin(), all.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(coarsest));
    return rest;
  };
  const double scale = dt[coarsest];
  const auto all = weights_of(dt, scale), rest = weights_of(without(dt), scale);
  const auto fewer = without(value);
  std::vector<interval_estimate> out;
  for (std::size_t j = 0; j < count; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    double best = 0, before = 0, noise = 0;
    for (std::size_t i = 0; i < dt.size(); ++i) {
      best += all(row, static_cast<Eigen::Index>(i)) * value[i];
      noise += std::fabs(all(row, static_cast<Eigen::Index>(i))) * uncertainty[i];
    }
    for (std::size_t i = 0; i < fewer.size(); ++i) before += rest(row, static_cast<Eigen::Index>(i)) * fewer[i];
    const double unit = std::pow(scale, static_cast<double>(j));
    const double half = (next_terms * std::fabs(best - before) + noise) / unit;
    out.push_back({best / unit, best / unit - half, best / unit + half});
  }
  return out;
}

}  // namespace polhode
