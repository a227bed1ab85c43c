// SPDX-License-Identifier: Apache-2.0
// Are n steps in one run one step, n times?
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/common/judge.hpp"

namespace polhode {

inline constexpr const char* steps_claim = "n steps are one step, n times";

/// Of that claim: transfer operators take one step at a time, every other experiment runs many at
/// once, and a loop that leaves out the last one, or half of it, would be seen by neither alone. One block of paths,
/// one noise: in one call, in two pieces, and a step at a time; the same under one noise for all. Holds where all agree
/// to rounding in every lane.
report::verdict judge_steps(const context&, const scheme_entry&);

}  // namespace polhode
