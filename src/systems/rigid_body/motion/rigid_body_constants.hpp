// SPDX-License-Identifier: Apache-2.0
// What a rigid body, a step size and an orbit fix for every step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <polhode/vec.hpp>
#include "systems/rigid_body/motion/body_parts.hpp"
#include "systems/rigid_body/motion/shear_rotation.hpp"

namespace polhode {

/// Everything that depends on body, step size and orbit alone. Axes are numbered as the kernel numbers them.
struct rigid_body_constants {
  vec<double, 3> inverse_inertia;
  double theta, dt, radius;
  vec<double, 3> kappa;                                  ///< dt / I_k
  vec<double, 3> shifted;                                ///< dt (1/I_k - 1/I_2): the Casimir shift
  std::array<vec<shear_rotation<2>, 3>, 2> first_turns;  ///< if tiny: by these, over the whole step and half of it
  shear_rotation<1> last_half_turn;                      ///< the same about the axis 3, over half a step
  vec<double, 3> gamma;                                  ///< theta dt (Pi x Omega)_k = gamma_k Pi_i Pi_j
  std::array<vec<double, 3>, 2> damping;  ///< exp(-theta c^2 t (1/I_k - shift)) for the whole step and half of it
  /// The same over the least |y| that a whole step's damping leaves: |y| then is 1 at least, whatever the orbit's size.
  std::array<vec<double, 3>, 2> damping_to_unit;

  /// c: the orbit's |Pi|. The damping exponents are counted from 1/I_2, which makes its factor 1; where rotations have
  /// any size from the least 1/I, so that none of them overflows.
  rigid_body_constants(const vec<double, 3>& inverse, double theta_, double dt_, double c, rotation_size size)
      : inverse_inertia(inverse), theta(theta_), dt(dt_), radius(c) {
    const double least = std::min({inverse[0], inverse[1], inverse[2]});
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      kappa[k] = dt * inverse[k];
      shifted[k] = dt * (inverse[k] - inverse[1]);
      if (size == rotation_size::tiny)
        for (int n = 1; n <= 2; ++n) first_turns[n - 1][k] = shear_rotation<2>(shifted[k] / n, c);
      gamma[k] = theta * dt * (inverse[j] - inverse[i]);
      const double rate = theta * c * c * (inverse[k] - (size == rotation_size::any ? least : inverse[1]));
      damping[0][k] = std::exp(-rate * dt);
      damping[1][k] = std::exp(-rate * dt / 2);
    }
    if (size == rotation_size::tiny) last_half_turn = shear_rotation<1>(shifted[2] / 2, c);
    const auto& whole = damping[0];
    for (int n = 0; n < 2; ++n) damping_to_unit[n] = 1 / (c * std::min({whole[0], whole[1], whole[2]})) * damping[n];
  }

  /// Width of the range of |y|^2, from 1, after a whole step's damping to unit.
  double spread() const {
    const auto& whole = damping_to_unit[0];
    const double largest = radius * std::max({whole[0], whole[1], whole[2]});
    return largest * largest - 1;
  }
};

}  // namespace polhode
