// SPDX-License-Identifier: Apache-2.0
// Where h is stationary on the sphere: the equilibria of the motion, with and without dissipation.
//
//   Lambda c n + b = nu c n,  |n| = 1;  in the principal axes c n_i = b_i / (nu - lambda_i)  (secular equation of nu)
//
// Source: the trust-region problem, Gander, Golub, von Matt, Linear Algebra Appl. 114 (1989) 815-839.
#pragma once

#include <vector>

#include "sphere/sphere_problem.hpp"

namespace polhode {

struct equilibrium {
  Eigen::Vector3d direction;  ///< of length one
  double energy;
  Eigen::Vector2d curvature;  ///< increasing: second derivatives of h along the sphere, over |Pi|^2
  bool is_least() const { return curvature[0] >= 0; }
};

/// In order of energy. Without a field both ends of each principal axis, of equal eigenvalues any axes.
std::vector<equilibrium> equilibria(const sphere_problem&);

/// Columns, right-handed; the coordinate axes in their order where `quadratic` is diagonal.
Eigen::Matrix3d principal_axes(const sphere_problem&);

/// The energy to be climbed out of the second deepest well of h; 0 where there is one well, or a ring of them.
double barrier_between_wells(const sphere_problem&);

/// In the plane across a direction: two unit vectors that make a right-handed frame with it; of a coordinate axis the
/// next two.
Eigen::Matrix<double, 3, 2> tangent_frame(const Eigen::Vector3d& direction);

/// The second derivatives of h along the sphere in that frame, over |Pi|^2.
Eigen::Matrix2d curvature_at(const sphere_problem&, const Eigen::Vector3d& direction);

}  // namespace polhode
