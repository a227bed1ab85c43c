// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/layout.hpp"

#include <algorithm>
#include <sstream>

#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

// Throws where memory is missing: a stream by itself would end the text there, in silence.
std::istringstream reading(std::string_view text) {
  std::istringstream stream{std::string{text}};
  stream.exceptions(std::ios::badbit);
  return stream;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent, std::size_t first) {
  auto words = reading(text);
  std::string out, word;
  std::size_t column = first;
  bool line_is_empty = true;
  while (words >> word) {
    const auto columns = display_width(word);
    if (!line_is_empty && column + 1 + columns > width) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
      line_is_empty = true;
    }
    if (!line_is_empty) out += ' ';
    column += columns + (line_is_empty ? 0 : 1);
    out += word;
    line_is_empty = false;
  }
  return out;
}

std::string entries(std::span<const entry> list, std::size_t width) {
  constexpr std::size_t least_room = 24;
  std::size_t column = 0;
  for (const auto& e : list) column = std::max(column, display_width(e.name) + 2);
  const bool beside = column + least_room <= width;
  const auto indent = beside ? column : 2;
  std::string out;
  for (const auto& e : list) {
    out += e.name;
    auto lines = reading(e.text);
    for (auto [line, first] = std::pair{std::string{}, beside}; std::getline(lines, line); first = false) {
      const auto blanks = first ? column - display_width(e.name) : indent;
      out += (first ? "" : "\n") + std::string(blanks, ' ') + wrapped(line, width, indent, indent);
    }
    out += '\n';
  }
  return out;
}

}  // namespace polhode::cli
