// SPDX-License-Identifier: Apache-2.0
// Text laid out for a terminal of some width.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace polhode::cli {

/// Breaks between words only; every line after the first begins with `indent` blanks. `first` columns are already used.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0, std::size_t first = 0);

struct entry {
  std::string name, text;  ///< a line break in the text is kept
};

/// Names in a column and texts beside them; below them where there is no room.
std::string entries(std::span<const entry>, std::size_t width);

}  // namespace polhode::cli
