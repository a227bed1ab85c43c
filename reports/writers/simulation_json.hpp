// SPDX-License-Identifier: Apache-2.0
// The summary of a simulation as one JSON document.
#pragma once

#include <string>
#include <string_view>

#include "reports/model/simulation.hpp"

namespace polhode::report {

/// Everything but the states and the counts. A number that is not finite is null.
std::string to_json(const simulation&);

/// Whether the text begins as to_json(simulation) begins it.
bool looks_like_simulation(std::string_view beginning);

}  // namespace polhode::report
