// SPDX-License-Identifier: Apache-2.0
// The two ways in which a command can fail that are nobody's bug.
#pragma once

#include <stdexcept>

namespace polhode {

/// The user's input cannot be taken. The message is one line: file, key, value, and what would be accepted. Exit
/// code 2.
struct input_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The result could not be computed or written (disk full, read-only, out of memory). Exit code 4.
struct output_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace polhode
