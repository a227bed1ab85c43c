#include "sphere/sphere_problem.hpp"

#include <fmt/format.h>

#include <cmath>

#include "algebra/decompositions.hpp"

namespace polhode {

bool sphere_problem::along_axes() const {
  return quadratic.isDiagonal(0) && covariance.isDiagonal(0) && !has_field() && varying.empty();
}

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

sphere_problem body_on_sphere(const std::array<double, 3>& inertia, double damping, double radius,
                              const Eigen::Matrix3d& covariance) {
  return {Eigen::Vector3d(inertia.data()).cwiseInverse().asDiagonal(), damping, radius, covariance};
}

std::optional<sphere_function> named_observable(std::string_view name, const sphere_problem& problem) {
  using pi_type = const Eigen::Vector3d&;
  if (name == "energy")
    return [a = problem.quadratic, b = problem.field](pi_type pi) { return (0.5 * (a * pi) + b).dot(pi); };
  if (name == "casimir") return [](pi_type pi) { return 0.5 * pi.squaredNorm(); };
  if (name == "exp(pi3)") return [](pi_type pi) { return std::exp(pi[2]); };
  for (int k = 0; k < 3; ++k) {
    if (name == fmt::format("pi{}", k + 1)) return [k](pi_type pi) { return pi[k]; };
    if (name == fmt::format("pi{}^2", k + 1)) return [k](pi_type pi) { return pi[k] * pi[k]; };
  }
  return std::nullopt;
}

}  // namespace polhode
