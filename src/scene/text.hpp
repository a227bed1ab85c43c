// Text that comes from outside: made fit for one line of a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode {

/// True for valid UTF-8 without control characters.
bool is_plain_text(std::string_view text);

/// The text in one line: white space folded, control characters and invalid bytes shown as \xNN, cut with "…" at
/// `limit` columns.
std::string one_line(std::string_view text, std::size_t limit = 1000);

/// Columns that the text takes on a terminal.
std::size_t display_width(std::string_view text);

}  // namespace polhode
