// SPDX-License-Identifier: Apache-2.0
// What is asked of recorded data.
#pragma once

namespace polhode::recorded_claim {

inline constexpr const char *casimir = "casimir", *transition_law = "transition law", *energy_law = "energy law",
                            *stationary_law = "stationary law";

}  // namespace polhode::recorded_claim
