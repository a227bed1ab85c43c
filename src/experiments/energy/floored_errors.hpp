// SPDX-License-Identifier: Apache-2.0
// Errors without sampling, over levels at which rounding may hide them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

/// Errors at every level of a grid, and the floor of each: ten times what the references (5e-15) and the rounding of so
/// many steps, a random walk, leave, in units of `size`, that of the state or of the energy.
struct floored_errors {
  std::vector<double> dt, values, floors;
  std::vector<double> most_rounding;  ///< where every step rounds alike, as a body's that turns about its own axis

  floored_errors(const level_grid&, std::vector<double> errors, double size);

  /// The first level at its floor after one above it: from there on rounding grows and the error is not seen.
  std::size_t reaches_floor() const;

  /// Takes no notice of what is at its floor, or finer, nor of what rounding moves by more than a fortieth, as that
  /// would bend the line.
  std::optional<order_fit> fit() const;
};

/// The series with its fit, and the verdict on its order, which is at least `expected`. Where too few levels are above
/// the floor for a fit: errors at the floor throughout are exactness on this scene; else the fall from the coarsest
/// level to another bounds the order from below.
void report_order(const quantity&, const std::string& claim, const floored_errors&, double expected, recorder&);

}  // namespace polhode
