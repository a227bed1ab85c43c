// SPDX-License-Identifier: Apache-2.0
#include "statistics/noise/area_strength.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "statistics/distributions.hpp"

namespace polhode {
namespace {

constexpr std::size_t most_levels = 6, least_levels = 4;

/// [path] the limit of a quantity over dt, by weights of the levels over dt.
Eigen::ArrayXd limits(const squared_errors& e, int paths, const Eigen::VectorXd& weights) {
  const auto n = static_cast<Eigen::Index>(weights.size());
  return Eigen::ArrayXd::NullaryExpr(paths, [&](Eigen::Index p) {
    return weights.dot(Eigen::Map<const Eigen::VectorXd>(e.values.data() + (p + 1) * e.levels - n, n));
  });
}

/// A mean over paths, and its standard error.
struct estimate {
  double value, error;
  explicit estimate(const Eigen::ArrayXd& x)
      : value(x.mean()), error(std::sqrt((x - x.mean()).square().sum()) / static_cast<double>(x.size())) {}
};

}  // namespace

multiplier area_strength(std::span<const double> dt, const area_response& r, int paths, int cells) {
  const auto used = dt.last(std::min(dt.size(), most_levels));
  const auto n = static_cast<Eigen::Index>(used.size());
  if (used.size() < least_levels) return {};
  const Eigen::ArrayXd over_dt = Eigen::Map<const Eigen::ArrayXd>(used.data(), n).inverse();
  const auto weights_of = [&](int degree) -> Eigen::VectorXd {
    return constant_of_polynomial(used, degree).array() * over_dt;
  };
  const Eigen::VectorXd weights = weights_of(2), fewer = weights_of(1);
  const auto square = limits(r.square, paths, weights), product = limits(r.product, paths, weights);
  const auto less_square = limits(r.square, paths, fewer), less_product = limits(r.product, paths, fewer);
  const estimate area(square);
  const double unsure = family_z * area.error + std::fabs(less_square.mean() - area.value);
  if (!(area.value > unsure)) return {};
  const double eps = product.mean() / area.value;
  if (!std::isfinite(eps)) return {};
  const estimate error((product - eps * square) / area.value),
      change((less_product - product - eps * (less_square - square)) / area.value);
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(n, n - 1) / used.back();
  const double step = limits(r.product, paths, last).mean() / limits(r.square, paths, last).mean() - eps;
  const double cell = std::fabs(eps) / cells;
  const double half = half_width_with_bias(error.error, left_open(used, step, change.value, change.error) + cell);
  return {true,
          {eps, eps - half, eps + half},
          family_z * error.error + std::fabs(change.value) + cell,
          std::sqrt(area.value * used.back())};
}

}  // namespace polhode
