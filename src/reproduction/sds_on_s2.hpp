// SPDX-License-Identifier: Apache-2.0
// What Gogoi, Panda, Hazra and Pakrashi publish, a figure each.
#pragma once

#include <polhode/vec.hpp>

#include "reproduction/reproduce.hpp"

namespace polhode {

using point_on_s2 = vec<double, 3>;

/// Figure 5: orders of weak schemes. Adds numbers, curves and notes.
void add_figure_5(const reproduce_options&, report::reproduction&);

}  // namespace polhode
