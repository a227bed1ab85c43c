// SPDX-License-Identifier: Apache-2.0
// How far a scheme's energy is from that of the true path, without noise: what the choice of an integrator and the
// tables of cost rest on.
#pragma once

#include "problem/subject.hpp"

namespace polhode {

/// The true energy at a few times up to the horizon, known to rounding.
class energy_truth {
 public:
  static constexpr int times = 8;

  /// still: a subject without noise.
  energy_truth(const subject& still, double horizon);

  /// The largest distance at these times (each at the nearest whole step before it), in units of |h_0|; not finite
  /// where the scheme fails.
  double error(const scheme_entry&, double dt) const;

 private:
  double at(double t) const;

  const subject& still_;
  double horizon_, unit_;
};

}  // namespace polhode
