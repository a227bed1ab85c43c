// SPDX-License-Identifier: Apache-2.0
// How the drift of the Casimirs grows with the number of steps, and what it is over as many as are judged.
#pragma once

#include <optional>
#include <vector>

#include "statistics/orders/order_fit.hpp"

namespace polhode {

inline constexpr double rounding_bound = 1e-12;  ///< relative drift allowed after a million steps
inline constexpr double judged_steps = 1e6;

/// The drift of one block of paths at growing numbers of steps.
struct drift_growth {
  std::vector<double> steps, rms, largest;

  /// rms = prefactor * n^order; nothing where fewer than two drifts are positive.
  std::optional<order_fit> law() const { return fit_power_law(steps, rms); }

  /// The largest per million steps. A shorter run is taken on as it grows: no slower than a random walk, n^(1/2), and
  /// linearly where its law is not known.
  double judged() const;

  /// The run is shorter than what is judged, and its judged drift is beyond the bound by less than ten: a guess that
  /// refutes nothing, so the run has to go on.
  bool has_to_go_on() const;
};

}  // namespace polhode
