// SPDX-License-Identifier: Apache-2.0
// The experiment `lyapunov` where the system does not live on one sphere: the whole spectrum on its orbit, sampled.
#pragma once

#include <optional>
#include <string>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// Why this scene has no exponents that could be sampled; empty: it has.
std::optional<std::string> no_orbit_exponents(const subject&);

/// Exponents of the equation with what follows from them; of every scheme that keeps the orbit, whether it has the same
/// and whether its sum is the mean divergence.
void report_orbit_exponents(const context&, report::results&);

}  // namespace polhode
