// SPDX-License-Identifier: Apache-2.0
// What a user may require of a scheme besides its accuracy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "selection/goal.hpp"

namespace polhode {

/// Throws input_error on an unknown name, on a contradiction, and where no candidate has all that its info can tell.
void check_requirements(const std::vector<std::string>& wanted, const std::vector<candidate>&);

/// What the candidate lacks; empty: nothing that its info can tell.
std::optional<std::string> lacks(const candidate&, const std::vector<std::string>& wanted);

/// Does the energy never rise in a run without noise at this dt?
bool monotone_energy(const subject&, const candidate&, double dt);

}  // namespace polhode
