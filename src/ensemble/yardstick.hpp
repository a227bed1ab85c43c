// SPDX-License-Identifier: Apache-2.0
// A loop that never changes: what the processor is worth at this moment, to which the cost of a step is related.
#pragma once

#include <cstdint>

#include "platform/isa_entry.hpp"

namespace polhode {

/// Steps of 64 lanes, as a kernel with noise of its own makes them: shears of three numbers with a table from the
/// nearest cache, and rounds of 32-bit products as a generator's.
struct yardstick_loop {
  int steps;
  const double* table;   ///< [16][3][64]
  double* states;        ///< [3][64]
  std::uint32_t* mixed;  ///< [2][64]
};

inline constexpr int yardstick_rows = 16;

/// By the instruction set in force. Timings are comparable only while this loop is what it is: do not tune it.
void run_yardstick(const yardstick_loop&);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_yardstick_, const polhode::yardstick_loop&);
