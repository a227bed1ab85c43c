// SPDX-License-Identifier: Apache-2.0
// The equation beside an equilibrium n of h, with noise along n alone: then n is an equilibrium of the noisy equation
// too, and what is near it obeys a linear equation. Momentum c n + F x, F the frame of two vectors across n, H the
// curvature of h there (sphere/equilibria.hpp):
//
//   dx = A x dt + sigma R x o dW,   A = c J H - theta c^2 H,   J = ( 0 -1)   R = -J                      (Stratonovich)
//                                                                 ( 1  0)
//
// Mean squares E[x1^2 + x2^2], E[x1^2 - x2^2], E[2 x1 x2] obey a linear equation without noise; its greatest eigenvalue
// is their rate of growth, below zero where the axis is stable in mean square: Arnold, Stochastic Differential
// Equations (1974), 11.2; for schemes Saito, Mitsui, SIAM J. Numer. Anal. 33 (1996) 2254-2267.
#pragma once

#include "sphere/sphere_problem.hpp"

namespace polhode {

struct linearised_equation {
  Eigen::Matrix2d drift;  ///< A, per time
  double noise = 0;       ///< sigma >= 0, per root of time
};

/// direction: an equilibrium, of length one; sigma: strength of the noise along it. The problem's own noise is not
/// read.
linearised_equation linearised_about(const sphere_problem&, const Eigen::Vector3d& direction, double sigma);

/// Of mean squares, per time: twice that of lengths where there is no noise.
double mean_square_growth(const linearised_equation&);

}  // namespace polhode
