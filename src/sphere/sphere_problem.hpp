// SPDX-License-Identifier: Apache-2.0
// A Lie-Poisson diffusion on a sphere of momentum, as its generator sees it: a body, a gyrostat or a spin.
//
//   dPi = Pi x (Omega + damping Pi x Omega) dt + sum_i Pi x sigma_i o dW^i          (Stratonovich),
//   h = Pi.quadratic Pi / 2 + field.Pi,   Omega = grad h,   covariance Q = sum_i sigma_i sigma_i^T
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// sigma(Pi) = constant + slope Pi.
struct affine_noise {
  Eigen::Vector3d constant;
  Eigen::Matrix3d slope;
};

/// quadratic symmetric of any signature, damping >= 0, radius |Pi| > 0, covariance symmetric and positive semidefinite;
/// isotropic: sigma^2 times one.
struct sphere_problem {
  Eigen::Matrix3d quadratic;
  double damping;
  double radius;
  Eigen::Matrix3d covariance;
  Eigen::Vector3d field = Eigen::Vector3d::Zero();
  std::vector<affine_noise> varying = {};  ///< noise that depends on the state, besides the constant one

  double energy(const Eigen::Vector3d& pi) const { return (0.5 * (quadratic * pi) + field).dot(pi); }
  Eigen::Vector3d rate(const Eigen::Vector3d& pi) const { return quadratic * pi + field; }  ///< Omega

  bool has_field() const { return !field.isZero(0); }
  bool has_noise() const { return !covariance.isZero(0) || !varying.empty(); }
  /// Differences of the eigenvalues of `quadratic`, the greatest: of h, what is no multiple of the Casimir. 0: none.
  double spread() const;
  bool is_spherical() const { return spread() == 0 && !has_field(); }  ///< h is a function of |Pi| alone
};

/// The rigid body: h = sum_j Pi_j^2 / (2 I_j). inertia > 0.
sphere_problem body_on_sphere(const std::array<double, 3>& inertia, double damping, double radius,
                              const Eigen::Matrix3d& covariance);

/// The same with noise, or dissipation, greater by that share.
sphere_problem with_more_noise(sphere_problem, double share);
sphere_problem with_more_dissipation(sphere_problem, double share);

/// A bound on |h| over the sphere, reached without a field where `quadratic` is positive.
double greatest_energy_on(const sphere_problem&);
/// A bound on |Omega| over the sphere, a turn per time.
double greatest_rate_on(const sphere_problem&);

using sphere_function = std::function<double(const Eigen::Vector3d& pi)>;

/// A function of the state that has a name.
struct observable_entry {
  std::string name, meaning;
};
std::vector<observable_entry> named_observables();
/// One of them, or mu_1, mu_2, mu_3 for the components.
std::optional<sphere_function> named_observable(std::string_view name, const sphere_problem&);

}  // namespace polhode
