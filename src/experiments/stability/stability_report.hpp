// SPDX-License-Identifier: Apache-2.0
// What the experiment on stability says of what it found.
#pragma once

#include <span>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/stability/stability_case.hpp"
#include "experiments/stability/stability_limit.hpp"

namespace polhode {

// The equation has no scale: Pi -> s Pi, theta -> theta/s, sigma -> sqrt(s) sigma, t -> t/s maps solutions onto
// solutions. A scheme should not have one either.

/// For |Pi| from 1e-150 to 1e150: the claim, and how far down and up it holds.
void report_scale(const context&, const scheme_entry&, recorder&);

/// Of no scheme: rate, horizon and true mean energy of each case.
void report_cases(const std::vector<stability_case>&, recorder&);

/// Of one scheme: [case].
void report_limits(const std::vector<stability_case>&, std::span<const finding>, recorder&);

/// Of a scheme that claims the Casimirs, over all cases whose |Pi| has a square; of others nothing.
void judge_orbit(const scheme_entry&, const std::vector<stability_case>&, std::span<const finding>, recorder&);

}  // namespace polhode
