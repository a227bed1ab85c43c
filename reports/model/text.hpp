// SPDX-License-Identifier: Apache-2.0
// Text that comes from outside, one UTF-8 character after the other: made fit for one line of a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// A code point and the bytes that it was read from.
struct character {
  std::string_view bytes;
  char32_t point = 0;
  bool valid = false;  ///< false: one byte that begins no valid UTF-8; its point means nothing
};

/// Takes the first character off a text that is not empty.
character take_character(std::string_view& text);

/// True for valid UTF-8 without control characters.
bool is_plain_text(std::string_view text);

/// The text in one line: white space folded, control characters and invalid bytes shown as \xNN, cut with "…" at
/// `limit` columns.
std::string one_line(std::string_view text, std::size_t limit = 1000);

/// Columns that the text takes on a terminal.
std::size_t display_width(std::string_view text);

}  // namespace polhode
