// SPDX-License-Identifier: Apache-2.0
// The generators of all rigid bodies at once, as a linear family: L = sum_j k_j A_j + sum_j (theta k)_j B_j +
// sum_{i<=j} Q_ij C_ij with k_j = 1/I_j, and the member that is nearest to a given operator.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "sphere/sphere_problem.hpp"

namespace polhode {

/// A common multiple of k, and of theta k, belongs to the Casimir and is seen by no function: both add up to zero.
struct body_parameters {
  Eigen::Vector3d quadratic, dissipation;  ///< k_j = 1/I_j and theta/I_j, each less its mean
  Eigen::Matrix3d noise;                   ///< Q = sum_i sigma_i sigma_i^T
};
body_parameters parameters_of(const sphere_problem&);

struct nearest_body {
  body_parameters parameters;
  double residual;  ///< what the family cannot express, over what there is to express
};

/// Least squares over the columns of degree 1 and 2, the first harmonics that tell all parameters apart, in orthonormal
/// harmonics.
class generator_family {
 public:
  static constexpr int fitted_degree = 2;   ///< of the columns
  static constexpr int reached_degree = 4;  ///< of the rows that a member fills

  explicit generator_family(double radius);

  /// generator: its columns of degree 1 and 2, a row a harmonic up to some degree >= reached_degree.
  nearest_body nearest(const Eigen::MatrixXd& generator) const;

 private:
  double radius_;
  Eigen::MatrixXd members_;  ///< a column a parameter: k, theta k, Q_11, Q_12, Q_13, Q_22, Q_23, Q_33
  Eigen::MatrixXd solve_;    ///< its pseudo-inverse
};

/// The columns of degree 1 and 2 of log(T)/dt, T the operator of one step; empty where they do not converge.
std::optional<Eigen::MatrixXd> generator_of_step(const Eigen::MatrixXd& step, double dt);

}  // namespace polhode
