// SPDX-License-Identifier: Apache-2.0
#include "sphere/closed_forms/energy_drift.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/exponential_action.hpp"
#include "sphere/harmonics/backward_operator.hpp"

namespace polhode {
namespace {

constexpr int degree = 16, more_degrees = 4;
constexpr double drift_rounding = 1e-15;  // of the greatest energy

sphere_problem without_dissipation(sphere_problem p) {
  p.damping = 0;
  return p;
}

bool is_isotropic(const Eigen::Matrix3d& q) { return q.isApprox(q(0, 0) * Eigen::Matrix3d::Identity(), 1e-14); }

Eigen::VectorXd energies(const sphere_problem& p, const points_on_sphere& at) {
  return 0.5 * (at * p.quadratic).cwiseProduct(at).rowwise().sum() + at * p.field;
}

Eigen::VectorXd energy_coefficients(const sphere_problem& p, int up_to) {
  const auto energy = *named_observable("energy", p);
  return harmonic_coefficients([&](const Eigen::Vector3d& x) { return energy(p.radius * x); }, up_to);
}

Eigen::VectorXd by_harmonics(const sphere_problem& p, const points_on_sphere& from, double time, int up_to) {
  return harmonics(from.rowwise().normalized(), up_to) *
         exponential_action(backward_operator(p, up_to), time, energy_coefficients(p, up_to));
}

}  // namespace

double mean_energy_over_sphere(const sphere_problem& p) { return p.radius * p.radius / 6 * p.quadratic.trace(); }

double relaxed_energy(const sphere_problem& p, double energy, double time) {
  const double mean = mean_energy_over_sphere(p);
  return mean + (energy - mean) * std::exp(-3 * p.covariance(0, 0) * time);
}

mean_energies energy_without_dissipation(const sphere_problem& problem, const points_on_sphere& from, double time) {
  const auto p = without_dissipation(problem);
  Eigen::VectorXd value = energies(p, from);
  const double floor = drift_rounding * value.cwiseAbs().maxCoeff();
  if (is_isotropic(p.covariance) && !p.has_field() && p.varying.empty()) {
    for (double& h : value) h = relaxed_energy(p, h, time);
    return {value, floor};
  }
  value = by_harmonics(p, from, time, degree + more_degrees);
  const double change = (value - by_harmonics(p, from, time, degree)).cwiseAbs().maxCoeff();
  return {value, std::max(change, 10 * floor)};
}

Eigen::VectorXd energy_drift(const sphere_problem& problem, const points_on_sphere& at) {
  const auto p = without_dissipation(problem);
  constexpr int reached = 3;
  return harmonics(at.rowwise().normalized(), reached) *
         (backward_operator(p, reached) * energy_coefficients(p, reached));
}

}  // namespace polhode
