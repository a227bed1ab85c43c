// SPDX-License-Identifier: Apache-2.0
// What tape_kernel.cpp calls of each instruction set, and what is compiled there for all of them.
#pragma once

#include <memory>

#include "ensemble/tapes/tape_kernel.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

struct tape_on_faces {
  std::shared_ptr<const face> values, tangents;
  scheme_tapes tapes;
};

/// (1 - slope / 2)^-1, both [row][column][lane] of n rows: where steps hardly ever get to.
void inverse_derivative_by_lanes(const double* slope, int n, int lanes, double* out);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_tape_kernel_, polhode::tape_on_faces, std::unique_ptr<polhode::kernel>&);
POLHODE_DECLARE_ENTRIES(polhode_tape_tangent_kernel_, polhode::tape_on_faces,
                        std::unique_ptr<polhode::tangent_kernel>&);
