// SPDX-License-Identifier: Apache-2.0
// Into how many cells a step is cut where the areas of its path are asked for.
#pragma once

#include <algorithm>
#include <cmath>

namespace polhode {

inline constexpr int fewest_cells = 8;

/// Levy areas of a step are known to dt / sqrt(cells) from the increments of its cells (Chen's relation); for errors of
/// strong order one that takes about 1/dt of them, in units of the fastest rate. They are part of what a step costs.
inline int cells_for_areas(double rate, double dt) {
  return std::max(fewest_cells, static_cast<int>(std::ceil(1 / (rate * dt))));
}

}  // namespace polhode
