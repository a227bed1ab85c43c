// SPDX-License-Identifier: Apache-2.0
// What becomes of the command where memory cannot be had.
#pragma once

#include <string_view>

namespace polhode::cli {

/// From here on it ends there, in whichever thread: one line, signed so, that exit code, and what was being written is
/// removed as by a signal. No exception is passed on, as it would damage what it passes: Eigen 3.4 frees the block of a
/// matrix before it asks for one of another size, and keeps the address; nlohmann-json 3.11.2 destroys an object that
/// it could not make.
void end_where_memory_ends(int code, std::string_view signature);

}  // namespace polhode::cli
