// SPDX-License-Identifier: Apache-2.0
// Text that came from outside, made fit for each format. In one line of a message: reports/model/text.hpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polhode::report {

/// The same text with U+FFFD for every byte that is not UTF-8.
std::string valid_utf8(std::string_view);

/// valid_utf8, and U+FFFD for what XML and HTML forbid even as a reference (control characters, non-characters).
std::string printable(std::string_view);

/// printable, with & < > " ' as references: safe as HTML or XML text and inside a quoted attribute.
std::string escape_html(std::string_view);

/// printable, on one line, with HTML and Markdown's own marks made harmless; safe inside a table cell.
std::string escape_markdown(std::string_view);

/// At most `limit` code points, the last of them an ellipsis where something was cut.
std::string shortened(std::string_view, std::size_t limit);

/// Of names of our own: "λ₁" for "lambda_1", "σ" for "sigma", a blank for "_".
std::string as_written(std::string text);

}  // namespace polhode::report
