// SPDX-License-Identifier: Apache-2.0
// What a scheme asks of a system at compile time, as values: a tape is written for each answer that a scheme can tell
// apart, and chosen by the system's own.
#pragma once

namespace polhode {

/// unbracketed: varying, with brackets that nobody knows.
enum class taped_noise { none, constant, varying, unbracketed };

/// What a scheme asks of a system at compile time. components: those of a system of fixed size; -1 where that is
/// known at run time alone, or the scheme need not know it.
struct taped_traits {
  int components = -1;
  taped_noise noise = taped_noise::constant;
  bool exact_dissipation = true, flows = true, turns = true, matrices = true;
  bool joins = false;  ///< no scheme asks for it: whether the face takes two operations in one pass
};

}  // namespace polhode
