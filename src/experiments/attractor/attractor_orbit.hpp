// SPDX-License-Identifier: Apache-2.0
// The experiment `attractor` where the system does not live on one sphere.
#pragma once

#include <optional>
#include <string>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// Why nothing gathers on this scene; empty: it may.
std::optional<std::string> no_orbit_attractor(const subject&);

/// Of every scheme that keeps the orbit: whether neighbours meet or part at the rate lambda_1 of the equation, and
/// bodies from all over the orbit stay on it. Of the equation: densities to look at, and how far its bodies spread.
void report_orbit_attractor(const context&, report::results&);

}  // namespace polhode
