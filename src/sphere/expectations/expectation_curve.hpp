// SPDX-License-Identifier: Apache-2.0
// Expectations at every time up to a horizon, of several functions at once.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "sphere/sphere_problem.hpp"

namespace polhode {

/// t -> E[f_i(Pi_t)] on [0, time] in Chebyshev polynomials of t: a column a function.
class expectation_curve {
 public:
  expectation_curve(double time, Eigen::MatrixXd coefficients, Eigen::VectorXd uncertainty, std::string reason)
      : time_(time),
        coefficients_(std::move(coefficients)),
        uncertainty_(std::move(uncertainty)),
        reason_(std::move(reason)) {}

  Eigen::VectorXd at(double t) const;
  /// Of each function, the largest over all times.
  const Eigen::VectorXd& uncertainty() const { return uncertainty_; }
  /// Empty if converged, else one sentence.
  const std::string& reason() const { return reason_; }

 private:
  double time_;
  Eigen::MatrixXd coefficients_;
  Eigen::VectorXd uncertainty_;
  std::string reason_;
};

/// From Pi_0 = start (of length radius), with noise, time > 0. One law is taken from node to node by exp(t L^T) and
/// paired with every function. Nodes are doubled until the polynomial's tail, and what it is off at three times between
/// them, and the degree is raised until two successive changes, are below accuracy times scale_i; at the horizon it is
/// held against `expectation`, and what they differ by is part of the uncertainty.
expectation_curve expectations(const sphere_problem&, std::span<const sphere_function>, const Eigen::VectorXd& scale,
                               const Eigen::Vector3d& start, double time, double accuracy);

}  // namespace polhode
