// SPDX-License-Identifier: Apache-2.0
// What the command needs to know of the terminal and the standard streams.
#pragma once

#include <cstddef>
#include <string_view>

namespace polhode::cli {

/// A closed standard stream must not be replaced by the next file that is opened.
void hold_standard_streams();

/// Columns of the terminal behind a descriptor; the environment's COLUMNS first; 80 where neither is known.
std::size_t terminal_width(int descriptor);

/// Writes all of it to standard output. A reader that has gone is no error; anything else throws output_error.
void print(std::string_view text);

/// One line `polhode: …` on standard error, whatever the text holds. Never throws.
void print_error(std::string_view text) noexcept;

/// Writes all of it to standard error, where standard output belongs to another document. Never throws.
void print_aside(std::string_view text) noexcept;

}  // namespace polhode::cli
