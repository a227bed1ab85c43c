// SPDX-License-Identifier: Apache-2.0
// The equation has no scale: Pi -> s Pi, theta -> theta/s, sigma -> sqrt(s) sigma, t -> t/s maps solutions onto
// solutions. A scheme should not have one either.
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

/// For |Pi| from 1e-150 to 1e150: the claim, and how far down and up it holds.
void report_scale(const context&, const scheme_entry&, recorder&);

}  // namespace polhode
