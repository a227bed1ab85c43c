// SPDX-License-Identifier: Apache-2.0
// The errors that earlier experiments of a run found, gathered by kind and each in units of its own size.
#pragma once

#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"

namespace polhode {

struct known_error {
  std::string scheme;
  double dt, value, low, high;
};

struct error_kind {
  std::string name;    ///< strong, weak, stationary, energy_law, casimir
  std::string source;  ///< the experiment that finds it
  std::string unit;
  bool silent = false;       ///< found without noise, so that its cost is one without noise
  bool along_paths = false;  ///< areas are those of the path, and are paid for
  std::vector<known_error> errors = {};
};

/// In this order: strong, weak, stationary, energy_law, casimir; of a kind that was not asked for there are none. Where
/// several observables were looked at, the worst counts. Schemes that keep the Casimirs are run here, over the levels
/// at which the others' drift is found.
std::vector<error_kind> known_errors(const context&);

}  // namespace polhode
