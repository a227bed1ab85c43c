// SPDX-License-Identifier: Apache-2.0
// The law of the next state, given this one: P_t = exp(t L) as functions of the state before. No sampling.
#pragma once

#include <Eigen/Core>
#include <string>

#include "sphere/sphere_problem.hpp"

namespace polhode {

/// E[Y_lm(X_t / c) | X_0 = c x] = columns.col(lm) . Y(x), Y the harmonics up to `degree` at the unit vector x, c the
/// radius.
struct transition_law {
  int degree = 0;
  Eigen::MatrixXd columns;  ///< a harmonic l <= reach of the state after a column
  double uncertainty = 0;   ///< of any of them anywhere, proved (sphere/expectations/expectation.hpp)
  std::string reason = {};  ///< why that is more than was asked for; empty: it is not
};

/// time > 0, noise not zero. The degree is raised until the uncertainty is below the tolerance. wanted: the degree; 0
/// lets the program choose.
transition_law transition(const sphere_problem&, double time, int reach, double tolerance, int wanted = 0);

}  // namespace polhode
