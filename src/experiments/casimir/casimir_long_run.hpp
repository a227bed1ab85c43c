// SPDX-License-Identifier: Apache-2.0
// Schemes that claim to keep the Casimirs, over millions of steps: only rounding may show.
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/common/noise_verdict.hpp"

namespace polhode {

/// Of each scheme that makes one, every path of its block counted; where none has to go on.
double steps_of_long_run(const subject&, effort, bool dear);

/// On one block of paths at the scene's finest dt: the drift over the number of steps, its growth law, the verdict.
/// dear: over a tenth of the steps, as at effort quick where a state is long.
void report_long_runs(const context&, bool dear, noise_log&, report::results&);

}  // namespace polhode
