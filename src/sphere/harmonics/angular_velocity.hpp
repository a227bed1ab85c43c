// SPDX-License-Identifier: Apache-2.0
// Omega and x cross Omega of Omega = A x + b on the unit sphere, as polynomials of x and as operators that multiply by
// them, whatever the functions are that the coordinates act on.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

/// A = radius times quadratic, symmetric, less a multiple of one; b = field.
struct angular_velocity {
  Eigen::Matrix3d a;
  Eigen::Vector3d b;
  bool operator==(const angular_velocity&) const = default;
};
inline double median_of(const Eigen::Vector3d& v) {
  return std::max(std::min(v[0], v[1]), std::min(std::max(v[0], v[1]), v[2]));
}
/// A multiple of one turns nothing, as x cross x = 0, but its rounding would drown the differences of a body next to
/// spherical: the middle one of the diagonal is taken off.
inline angular_velocity angular_velocity_of(const sphere_problem& p) {
  const Eigen::Matrix3d differences = p.quadratic - median_of(p.quadratic.diagonal()) * Eigen::Matrix3d::Identity();
  return {p.radius * differences, p.field};
}

/// constant + linear x + x.quadratic x, quadratic symmetric.
struct polynomial {
  double constant = 0;
  Eigen::RowVector3d linear = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d quadratic = Eigen::Matrix3d::Zero();
  bool is_zero() const { return constant == 0 && linear.isZero(0) && quadratic.isZero(0); }
};

/// Omega_i and (x cross Omega)_i.
polynomial rate_polynomial(const angular_velocity&, int i);
polynomial cross_polynomial(const angular_velocity&, int i);

/// Multiplies by the polynomial; x: the operators that multiply by the coordinates. What is zero costs nothing.
sparse_matrix multiplying_by(const polynomial&, const std::array<sparse_matrix, 3>& x);

}  // namespace polhode
