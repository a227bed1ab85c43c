// SPDX-License-Identifier: Apache-2.0
// How far a path has left its coadjoint orbit, and how that drift falls with dt for schemes that do not keep it.
#pragma once

#include <span>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/common/noise_verdict.hpp"

namespace polhode {

/// The largest relative change among the Casimirs since `start`, per lane; infinite where a state is not finite.
std::vector<double> casimir_drifts(const model&, std::span<const double> states, std::span<const double> start);

/// Of every scheme that does not claim to keep the Casimirs: the root-mean-square drift over the horizon against dt,
/// its order and the verdict.
void report_casimir_drift(const context&, noise_log&, report::results&);

/// That it draws at most.
int most_drift_paths(const context&);

}  // namespace polhode
