// SPDX-License-Identifier: Apache-2.0
// A program against the installed headers that runs what was chosen.
#pragma once

#include <string>

#include "selection/goal.hpp"

namespace polhode {

/// Mean energy of a thousand paths after `time`; cells: increments a step that Levy areas are made of, where the scheme
/// asks for them (1: they are drawn).
std::string snippet(const subject&, const candidate&, double dt, double time, int cells);

}  // namespace polhode
