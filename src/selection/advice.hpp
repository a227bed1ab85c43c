// SPDX-License-Identifier: Apache-2.0
// What the measured error laws say to the questions that people ask about integrators.
#pragma once

#include <string>
#include <vector>

#include "selection/search.hpp"

namespace polhode {

/// Sentences on keeping |Pi| and on higher order, from this scene's own error laws; by predicted costs.
std::vector<std::string> advice(const std::vector<prospect>&, const choice& winner, double tolerance);

}  // namespace polhode
