// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/text.hpp"

#include <algorithm>
#include <utility>

#include "reports/model/text.hpp"

namespace polhode::report {
namespace {

constexpr std::string_view replacement = "\uFFFD";

std::string_view valid_bytes(const character& c) { return c.valid ? c.bytes : replacement; }

template <class Map>
std::string mapped(std::string_view text, Map bytes_of) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) out += bytes_of(take_character(text));
  return out;
}

bool forbidden(char32_t point) {
  const bool control =
      (point < 0x20 && point != '\t' && point != '\n' && point != '\r') || (point >= 0x7F && point < 0xA0);
  return control || (point & 0xFFFE) == 0xFFFE;
}

bool word_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
}

// An underscore inside a word is no mark in GitHub's Markdown, and escaped it would make every name unreadable.
bool inside_word(std::string_view text, std::size_t at) {
  return at > 0 && at + 1 < text.size() && word_character(text[at - 1]) && word_character(text[at + 1]);
}

}  // namespace

std::string valid_utf8(std::string_view text) { return mapped(text, valid_bytes); }

std::string printable(std::string_view text) {
  return mapped(text, [](const character& c) { return forbidden(c.point) ? replacement : valid_bytes(c); });
}

std::string escape_html(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  return out;
}

std::string escape_markdown(std::string_view text) {
  const std::string clean = one_line(printable(text), text.npos);
  std::string out;
  for (std::size_t i = 0; i < clean.size(); ++i) switch (const char c = clean[i]) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '_':
        if (!inside_word(clean, i)) out += '\\';
        out += c;
        break;
      default:
        if (std::string_view("\\`*[]|~#").find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
  return out;
}

std::string shortened(std::string_view text, std::size_t limit) {
  std::string out;
  for (std::size_t count = 0; !text.empty(); ++count) {
    const auto c = take_character(text);
    if (count + 1 >= limit && !text.empty()) return out + "…";
    out += valid_bytes(c);
  }
  return out;
}

std::string as_written(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> letters[] = {
      {"lambda_1", "λ₁"}, {"lambda_2", "λ₂"}, {"sigma", "σ"}, {"theta", "θ"}};
  for (const auto& [name, letter] : letters)
    for (auto at = text.find(name); at != text.npos; at = text.find(name, at + letter.size()))
      text.replace(at, name.size(), letter);
  std::ranges::replace(text, '_', ' ');
  return text;
}

}  // namespace polhode::report
