// SPDX-License-Identifier: Apache-2.0
// The true mean energy at the horizon of every case, against which runs are held.
#pragma once

#include <vector>

#include "experiments/stability/stability_case.hpp"

namespace polhode {

/// Exact where harmonics of low degree are enough, else by the Wong-Zakai equation; in parallel. `hear`: of the first
/// that is sampled.
void find_mean_energies(const context&, std::vector<stability_case>&, const block_listener& hear = {});

}  // namespace polhode
