// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "statistics/orders/order_fit.hpp"
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"

namespace polhode {
namespace {

constexpr double certain = 1e-12;  // of a mean: no error is known better

/// One over the standard error of each level's mean; of a level that is zero on every path, as of the best of the
/// others.
Eigen::VectorXd weights_of(const squared_errors& e, const std::vector<std::size_t>& levels) {
  std::vector<double> errors;
  double least = INFINITY;
  for (const std::size_t level : levels) {
    const auto [mean, error] = level_mean(e, static_cast<int>(level));
    errors.push_back(std::max(certain * mean, error));
    if (errors.back() > 0) least = std::min(least, errors.back());
  }
  Eigen::VectorXd out = Eigen::Map<Eigen::VectorXd>(errors.data(), static_cast<Eigen::Index>(errors.size()));
  return (out.array() > 0).select(out, std::isfinite(least) ? least : 1).cwiseInverse();
}

}  // namespace

error_model fit_error_model(std::span<const double> dt, const squared_errors& e, const std::vector<bool>& used,
                            double order, std::uint64_t seed, int powers) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) kept.push_back(i);
  const auto n = static_cast<Eigen::Index>(kept.size());
  Eigen::MatrixXd design(n, 1 + powers);
  const Eigen::VectorXd weight = weights_of(e, kept);
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t level = kept[static_cast<std::size_t>(k)];
    design(k, 0) = 1;
    for (int i = 0; i < powers; ++i) design(k, 1 + i) = std::pow(dt[level], 2 * order + i);
  }
  const Eigen::RowVectorXd with_limit = pseudo_inverse(weight.asDiagonal() * design.leftCols(3)).row(0),
                           without = pseudo_inverse(weight.asDiagonal() * design.rightCols(powers)).row(0);
  const auto coefficients = [&](const Eigen::RowVectorXd& mean) {
    Eigen::VectorXd y(n);
    for (Eigen::Index k = 0; k < n; ++k) y[k] = weight[k] * mean[k];
    return std::pair{with_limit.dot(y), without.dot(y)};
  };
  std::vector<double> limits, leading;
  values_of_paths values(e.paths, n);
  for (Eigen::Index k = 0; k < n; ++k)
    values.col(k) = matrix_of(e).col(static_cast<Eigen::Index>(kept[static_cast<std::size_t>(k)]));
  const auto resampled = resampled_means(values, seed);
  for (Eigen::Index r = 0; r < resampled.rows(); ++r) {
    const auto [square, coefficient] = coefficients(resampled.row(r));
    limits.push_back(square);
    leading.push_back(coefficient);
  }
  const auto [square, coefficient] = coefficients(values.colwise().mean());
  const auto [low, high] = bootstrap_interval(limits, 0.95, e.paths);
  const auto [least, most] = bootstrap_interval(leading, 0.95, e.paths);
  const auto distance = [](double x) { return x < 0 ? 0 : std::sqrt(x); };
  return {{distance(square), distance(low), distance(high)}, {coefficient, least, most}};
}

}  // namespace polhode
