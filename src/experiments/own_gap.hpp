// How fast a scheme forgets its start: gap(dt) = -log|lambda_2| / dt, lambda_2 the eigenvalue of its operator T_dt that
// is largest in modulus besides the constants' 1. Against the equation's, the least decay rate of Kolmogorov's operator
// (references/kolmogorov.hpp): T_dt = exp(dt L) + O(dt^(p+1)), so that they differ by O(dt^p).
#pragma once

#include "experiments/law_averages.hpp"

namespace polhode {

/// The equation's; nothing, with the reason, where the reference has no certain answer other than zero.
struct known_gap {
  exact_averages gap;
  std::string reason;      ///< why there is none; else empty
  bool undecided = false;  ///< there is one, but it is not known
};
known_gap true_gap(const subject&);

/// The scheme's, from (1 - T)^-1 on functions without a constant part: its large eigenvalues belong to slow modes and
/// are found by Arnoldi's method. Not finite where none is.
double own_gap(const Eigen::MatrixXd& forgetting, double dt);

}  // namespace polhode
