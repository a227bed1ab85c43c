// The rigid body beside one of its axes, with noise along that axis alone: then the axis is an equilibrium of the noisy
// equation too, and what is near it obeys a linear equation. Momentum c e_j + x e_k + y e_l, (j,k,l) cyclic:
//
//   d(x,y) = A (x,y) dt + sigma R (x,y) o dW,   A = (-theta c^2 a   -c b        )   R = ( 0 1)
//                                                   (c a            -theta c^2 b)       (-1 0)
//   a = 1/I_k - 1/I_j,  b = 1/I_l - 1/I_j                                                        (Stratonovich)
//
// Mean squares E[x^2 + y^2], E[x^2 - y^2], E[2 x y] obey a linear equation without noise; its greatest eigenvalue is
// their rate of growth, below zero where the axis is stable in mean square: Arnold, Stochastic Differential Equations
// (1974), 11.2; for schemes Saito, Mitsui, SIAM J. Numer. Anal. 33 (1996) 2254-2267.
#pragma once

#include <array>

namespace polhode {

struct linearised_body {
  std::array<std::array<double, 2>, 2> drift;  ///< A, per time
  double noise = 0;                            ///< sigma >= 0, per root of time
};

/// axis: j from 0 to 2; momentum: c > 0; sigma: strength along the axis.
linearised_body linearised_about(int axis, const std::array<double, 3>& inertia, double theta, double momentum,
                                 double sigma);

/// Of mean squares, per time: twice that of lengths where there is no noise.
double mean_square_growth(const linearised_body&);

}  // namespace polhode
