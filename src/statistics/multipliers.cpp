// SPDX-License-Identifier: Apache-2.0
#include "statistics/multipliers.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "statistics/distributions.hpp"

namespace polhode {
namespace {

constexpr double least_share = 0.02;  // of a direction's mean square that those before it leave

using square_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Directions that add something to those before them.
std::vector<Eigen::Index> independent(const square_matrix& gram) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < gram.rows(); ++k) {
    double left = gram(k, k);
    if (!kept.empty()) {
      const Eigen::VectorXd across = gram(kept, k);
      left -= across.dot(pseudo_inverse(gram(kept, kept)) * across);
    }
    if (left > least_share * gram(k, k)) kept.push_back(k);
  }
  return kept;
}

/// mean S.error of one path, extrapolated to dt = 0.
Eigen::VectorXd at_zero(const response_data& d, int path, const Eigen::VectorXd& weights) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(d.directions);
  for (int l = 0; l < d.levels; ++l)
    out += weights[l] *
           Eigen::Map<const Eigen::VectorXd>(d.response.data() + (path * d.levels + l) * d.directions, d.directions);
  return out;
}

}  // namespace

Eigen::VectorXd constant_of_polynomial(std::span<const double> dt, int degree) {
  const auto n = static_cast<Eigen::Index>(dt.size());
  Eigen::MatrixXd design(n, degree + 1);
  Eigen::VectorXd weight(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = dt[static_cast<std::size_t>(i)] / dt.back();
    for (int k = 0; k <= degree; ++k) design(i, k) = std::pow(x, k);
    weight[i] = 1 / x;
  }
  const Eigen::MatrixXd weighted = weight.asDiagonal() * design;
  return (pseudo_inverse(weighted) * weight.asDiagonal()).row(0);
}

double left_open(std::span<const double> dt, double first, double second, double error) {
  const Eigen::ArrayXd x =
      Eigen::Map<const Eigen::ArrayXd>(dt.data(), static_cast<Eigen::Index>(dt.size())) / dt.back();
  const double line = constant_of_polynomial(dt, 1).dot(x.square().matrix());
  const double quadratic = constant_of_polynomial(dt, 2).dot(x.cube().matrix());
  const double seen = std::max(0.0, std::fabs(second) - 1.96 * error);
  const double further = std::fabs(second / first * quadratic) / (line * line);
  return further < 1 ? seen * further : seen;
}

response_data::response_data(int paths, int count, int finest)
    : directions(count),
      levels(finest),
      gram(static_cast<std::size_t>(paths * count * count)),
      response(static_cast<std::size_t>(paths * count * finest)) {}

std::vector<multiplier> effective_multipliers(std::span<const double> dt, const response_data& d, int paths,
                                              int cells) {
  const auto weights = constant_of_polynomial(dt, 2), fewer = constant_of_polynomial(dt, 1);
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(d.levels, d.levels - 1);
  const auto gram_of = [&](int path) {
    return Eigen::Map<const square_matrix>(d.gram.data() + path * d.directions * d.directions, d.directions,
                                           d.directions);
  };
  square_matrix gram = square_matrix::Zero(d.directions, d.directions);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(d.directions), other = mean, finest = mean;
  for (int p = 0; p < paths; ++p) {
    gram += gram_of(p) / paths;
    mean += at_zero(d, p, weights) / paths;
    other += at_zero(d, p, fewer) / paths;
    finest += at_zero(d, p, last) / paths;
  }
  const auto kept = independent(gram);
  const auto count = static_cast<Eigen::Index>(kept.size());
  const Eigen::MatrixXd inverse = pseudo_inverse(gram(kept, kept));
  const Eigen::VectorXd eps = inverse * mean(kept), change = inverse * other(kept) - eps,
                        step = inverse * finest(kept) - eps;
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(count), of_change = variance;
  for (int p = 0; p < paths; ++p) {
    const Eigen::VectorXd at = at_zero(d, p, weights)(kept), left = at - square_matrix(gram_of(p)(kept, kept)) * eps;
    variance += (inverse * left).cwiseAbs2();
    of_change += (inverse * (at_zero(d, p, fewer)(kept) - at) - change).cwiseAbs2();
  }
  std::vector<multiplier> out(static_cast<std::size_t>(d.directions));
  for (Eigen::Index i = 0; i < count; ++i) {
    const double error = std::sqrt(variance[i]) / paths, cell = std::fabs(step[i]) / cells;
    const double half =
        half_width_with_bias(error, left_open(dt, step[i], change[i], std::sqrt(of_change[i]) / paths) + cell);
    const auto k = kept[static_cast<std::size_t>(i)];
    out[static_cast<std::size_t>(k)] = {true,
                                        {eps[i], eps[i] - half, eps[i] + half},
                                        family_z * error + std::fabs(change[i]) + cell,
                                        std::sqrt(gram(k, k))};
  }
  return out;
}

}  // namespace polhode
