// SPDX-License-Identifier: Apache-2.0
#include "sphere/sphere_problem.hpp"

#include <fmt/format.h>

#include <cmath>

#include "algebra/decompositions.hpp"

namespace polhode {

namespace {

Eigen::Vector3d eigenvalues(const Eigen::Matrix3d& a) {
  if (a.isDiagonal(0)) return a.diagonal();  // no rounding
  return symmetric_eigenpairs_of(a).values;
}

}  // namespace

double sphere_problem::spread() const {
  const Eigen::Vector3d values = eigenvalues(quadratic);
  return values.maxCoeff() - values.minCoeff();
}

double greatest_energy_on(const sphere_problem& p) {
  return p.radius * (p.radius * eigenvalues(p.quadratic).cwiseAbs().maxCoeff() / 2 + p.field.norm());
}

double greatest_rate_on(const sphere_problem& p) {
  return p.radius * eigenvalues(p.quadratic).cwiseAbs().maxCoeff() + p.field.norm();
}

sphere_problem body_on_sphere(const std::array<double, 3>& inertia, double damping, double radius,
                              const Eigen::Matrix3d& covariance) {
  return {Eigen::Vector3d(inertia.data()).cwiseInverse().asDiagonal(), damping, radius, covariance};
}

std::vector<observable_entry> named_observables() {
  return {{"energy", "h"},     {"pi1", "Pi_1"},           {"pi2", "Pi_2"},
          {"pi3", "Pi_3"},     {"pi1^2", "Pi_1^2"},       {"pi2^2", "Pi_2^2"},
          {"pi3^2", "Pi_3^2"}, {"exp(pi3)", "exp(Pi_3)"}, {"casimir", "1/2 |Pi|^2"}};
}

std::optional<sphere_function> named_observable(std::string_view name, const sphere_problem& problem) {
  using pi_type = const Eigen::Vector3d&;
  if (name == "energy")
    return [a = problem.quadratic, b = problem.field](pi_type pi) { return (0.5 * (a * pi) + b).dot(pi); };
  if (name == "casimir") return [](pi_type pi) { return 0.5 * pi.squaredNorm(); };
  if (name == "exp(pi3)") return [](pi_type pi) { return std::exp(pi[2]); };
  for (int k = 0; k < 3; ++k) {
    if (name == fmt::format("pi{}", k + 1) || name == fmt::format("mu_{}", k + 1))
      return [k](pi_type pi) { return pi[k]; };
    if (name == fmt::format("pi{}^2", k + 1)) return [k](pi_type pi) { return pi[k] * pi[k]; };
  }
  return std::nullopt;
}

sphere_problem with_more_noise(sphere_problem p, double share) {
  p.covariance *= (1 + share) * (1 + share);
  for (auto& v : p.varying) v = {(1 + share) * v.constant, (1 + share) * v.slope};
  return p;
}

sphere_problem with_more_dissipation(sphere_problem p, double share) {
  p.damping *= 1 + share;
  return p;
}

}  // namespace polhode
