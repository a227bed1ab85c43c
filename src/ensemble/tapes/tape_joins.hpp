// SPDX-License-Identifier: Apache-2.0
// Operations of a tape that a face carries out in one pass.
#pragma once

#include <vector>

#include "ensemble/tapes/tape.hpp"

namespace polhode {

/// Whether it writes all rows of a state.
constexpr bool writes_state(tape_op op) {
  return op <= tape_op::select_rows || op == tape_op::times || op == tape_op::correct;
}

/// The operations of a whole step, two or three in one where nothing else reads what is between them. rows: of a state.
std::vector<tape_instruction> joined(std::vector<tape_instruction>, int rows);

}  // namespace polhode
