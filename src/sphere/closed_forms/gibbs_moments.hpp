// SPDX-License-Identifier: Apache-2.0
// Moments of a Bingham law on the unit sphere: what the Gibbs law of a rigid body is.
#pragma once

#include <array>

namespace polhode {

/// Under density exp(-beta y), y = a x_1^2 + b x_2^2: a >= b >= 0, beta >= 0.
struct bingham_moments {
  std::array<double, 3> square{};   ///< E[x_k^2]
  double mean = 0, variance = 0;    ///< of y
  double relative_uncertainty = 0;  ///< of the mean and of each square: the quadrature's own estimate, and rounding
};

/// With t = 1 - x_3^2 and x_1 = sqrt(t) cos(phi), the angle phi integrates in closed form:
///
///   density of t: exp(-beta b t) I0e(x) / sqrt(1 - t),  x = beta t (a - b) / 2,  I0e = exp(-x) I_0(x),
///   E[cos(2 phi) | t] = -r,  Var[cos(2 phi) | t] = r',  r = I_1(x) / I_0(x),  r' = 1 - r / x - r^2.
///
/// Adaptive Gauss-Kronrod on panels that widen geometrically from the lengths over which the factors fall.
/// Source: Mardia, Jupp, Directional Statistics (2000), section 9.4.3.
bingham_moments bingham(double a, double b, double beta);

}  // namespace polhode
