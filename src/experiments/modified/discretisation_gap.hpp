// SPDX-License-Identifier: Apache-2.0
// How fast a scheme forgets its start: gap(dt) = -log|lambda_2| / dt, lambda_2 the eigenvalue of its operator T_dt that
// is largest in modulus besides the constants' 1. Against the equation's, the least decay rate of Kolmogorov's operator
// (sphere/spectral_gap.hpp): T_dt = exp(dt L) + O(dt^(p+1)), so that they differ by O(dt^p). Where two modes are
// nearly as slow, which of them is the slowest may change with dt, and their maximum has a kink and no power series: so
// the mode is followed that continues the equation's, as long as it is the slowest but for an error of the step.
#pragma once

#include "experiments/laws/law_averages.hpp"

namespace polhode {

/// The equation's; nothing, with the reason, where the reference has no certain answer other than zero.
struct known_gap {
  exact_averages gap;
  std::string reason;       ///< why there is none; else empty
  bool undecided = false;   ///< there is one, but it is not known
  Eigen::VectorXcd mode{};  ///< the equation's slowest, in harmonics from degree 1 on; none where it was not found
};
known_gap true_gap(const subject&);

/// The scheme's, from (1 - T)^-1 on functions without a constant part: its large eigenvalues belong to slow modes and
/// are found by Arnoldi's method. Of the mode nearest to `mode` if its rate is above the slowest by at most
/// `error`, absolute, else the slowest's. Not finite where none is found.
double discretisation_gap(const Eigen::MatrixXd& forgetting, double dt, const Eigen::VectorXcd& mode, double error);

}  // namespace polhode
