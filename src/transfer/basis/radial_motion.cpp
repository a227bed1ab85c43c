// SPDX-License-Identifier: Apache-2.0
#include "transfer/basis/radial_motion.hpp"

#include <algorithm>
#include <cmath>

#include "problem/vectors.hpp"
#include "transfer/basis_sums.hpp"
#include "transfer/points/mapped_points.hpp"

namespace polhode {
namespace {

constexpr double widest = 0.8;  // of log(radius), to either side

/// Calls use(point, weight, log(|Pi after a step| / |Pi|)) for every point and node.
template <class Use>
void map_radii(const kernel& k, const points_in_space& points, const noise_nodes& noise, const Use& use) {
  const Eigen::VectorXd radii = points.rowwise().norm();
  map_each_point(k, points, noise, [&](int point, double weight, const Eigen::Vector3d& now) {
    use(point, weight, std::log(std::hypot(now[0], now[1], now[2]) / radii[point]));
  });
}

/// How log |Pi| changes in one step from the sphere: the extremes of its mean, the largest variance.
struct radial_motion {
  double least_mean, largest_mean, variance;
};

radial_motion motion_of(const kernel& k, double radius, const noise_nodes& noise) {
  const points_in_space points = radius * sphere_quadrature(6).points;
  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(points.rows()), square = mean;
  map_radii(k, points, noise, [&](int point, double weight, double change) {
    mean[point] += weight * change;
    square[point] += weight * change * change;
  });
  return {mean.minCoeff(), mean.maxCoeff(), std::max(0.0, (square - mean.square()).maxCoeff())};
}

/// Wide enough for the radius of a path.
shell shell_around(const kernel& k, double radius, const noise_nodes& noise, std::int64_t steps, double deviations) {
  const auto motion = motion_of(k, radius, noise);
  const auto n = static_cast<double>(steps);
  const double spread = deviations * std::sqrt(n * motion.variance);
  const auto width = [&](double drift) { return std::clamp(n * drift + spread, 1e-3, widest); };
  return {radius * std::exp(-width(-motion.least_mean)), radius * std::exp(width(motion.largest_mean))};
}

}  // namespace

shell shell_of(const kernel& k, const subject& s, const noise_nodes& noise, std::int64_t steps,
               const basis_rule& rule) {
  const double c = length(s.scene.momentum);
  return rule.radial == 1 ? shell{c, c} : shell_around(k, c, noise, steps, rule.deviations);
}

double taken_back(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                  const transfer_rule& rule) {
  if (rule.basis.radial == 1) return 0;
  constexpr int radii = 5, powers = 12;
  const auto stepper = scheme.make(dt);
  const auto noise = nodes_of(*s.model, scheme.needs_areas, dt, rule.noise);
  const double c = length(s.scene.momentum), n = static_cast<double>(steps);
  const shell around = shell_of(*stepper, s, noise, steps, rule.basis);
  const double middle = (around.least + around.greatest) / 2, half = (around.greatest - around.least) / 2;
  const double least = std::max(middle - most_outside * half, around.least / 4), most = middle + most_outside * half;
  const auto directions = sphere_quadrature(6).points;
  points_in_space points(directions.rows() * radii, 3);
  for (int i = 0; i < radii; ++i)
    points.middleRows(i * directions.rows(), directions.rows()) =
        (least + (most - least) * i / (radii - 1)) * directions;
  const double unit = 1 / std::sqrt(n * std::max(motion_of(*stepper, c, noise).variance, 1e-300));
  Eigen::ArrayXXd up = Eigen::ArrayXXd::Zero(points.rows(), powers), down = up;
  map_radii(*stepper, points, noise, [&](int point, double weight, double change) {
    const double factor = std::exp(unit * change), back = 1 / factor;
    double grown = weight, shrunk = weight;
    for (int k = 0; k < powers; ++k) {
      up(point, k) += grown *= factor;
      down(point, k) += shrunk *= back;
    }
  });
  const auto bound = [&](const Eigen::ArrayXXd& mean, double far) {
    double out = 1;
    for (int k = 0; k < powers; ++k)
      out = std::min(out, std::exp(n * std::max(0.0, std::log(mean.col(k).maxCoeff())) - (k + 1) * unit * far));
    return out;
  };
  return std::min(1.0, bound(up, std::log(most / c)) + bound(down, std::log(c / least)));
}

}  // namespace polhode
