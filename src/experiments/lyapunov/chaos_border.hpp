// SPDX-License-Identifier: Apache-2.0
// The border of chaos theta*(sigma), the root of lambda_1 in theta for each strength of the noise, and the map of
// lambda_1 over both. Nothing is sampled (sphere/lyapunov.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"
#include "transfer/transfer.hpp"

namespace polhode {

/// A number of the equation itself with its uncertainty; without a value `reason` says why.
report::measurement exact_row(const quantity&, std::optional<double> value, double uncertainty,
                              const std::string& reason, std::vector<report::coordinate> at = {});

/// Around the strengths of noise and dissipation that are of one size with the free motion; sigma: of noise in the
/// problem's own directions, sum of squares 3 sigma^2. Skipped where lambda_1 is not known even under strong noise.
void report_chaos_border(const context&, const sphere_problem&, recorder&, report::results&);

}  // namespace polhode
