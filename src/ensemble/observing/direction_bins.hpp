// SPDX-License-Identifier: Apache-2.0
// The bins of a block of bodies, compiled once per instruction set; they do not depend on which one runs.
#pragma once

#include <array>

#include "ensemble/kernel.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

/// As sphere_bins.hpp has them, [lane]; -1 for a body without direction: not finite, or at zero.
struct direction_bins {
  std::array<double, block_lanes> longitude, hemisphere;
};

/// Of states [component][lane] in three dimensions, of any finite length. By the instruction set in force.
void find_bins(const double* states, direction_bins&);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_find_bins_, const double*, polhode::direction_bins&);
