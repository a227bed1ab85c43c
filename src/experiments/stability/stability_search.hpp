// SPDX-License-Identifier: Apache-2.0
// The stability limits of all schemes in all cases, searched side by side, and the map of shares that stay whole.
//
// Searches ask for the same numbers of steps, and runs of as many steps have the same normals whatever their scheme,
// case and dt: those that ask for the same number run together, under noise that is drawn once.
#pragma once

#include <vector>

#include "experiments/stability/stability_case.hpp"
#include "experiments/stability/stability_limit.hpp"
#include "experiments/stability/stability_noise.hpp"

namespace polhode {

/// Of a cell of the map.
inline constexpr int map_paths = 256, map_paths_elsewhere = 64;

/// [scheme][case]
struct stability_findings {
  std::vector<finding> found;
  std::vector<std::vector<report::measurement>> map;  ///< of the cases along the axis of dissipation
};

stability_findings search_all(const context&, const std::vector<stability_case>&, heard_noise&);

}  // namespace polhode
