// SPDX-License-Identifier: Apache-2.0
#include "reports/model/text.hpp"

#include <fmt/format.h>

#include <boost/locale/utf.hpp>

namespace polhode {
namespace {

/// C0 and C1 controls, and what turns lines or their direction: never to be sent to a terminal as it is.
bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c <= 0x9f) || (c >= 0x200e && c <= 0x200f) || (c >= 0x2028 && c <= 0x202e) ||
         (c >= 0x2066 && c <= 0x2069);
}

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::size_t columns_of(char32_t c) {
  if ((c >= 0x300 && c <= 0x36f) || c == 0x200b || c == 0x200d || (c >= 0xfe00 && c <= 0xfe0f)) return 0;
  const bool wide = (c >= 0x1100 && c <= 0x115f) || (c >= 0x2e80 && c <= 0xa4cf) || (c >= 0xac00 && c <= 0xd7a3) ||
                    (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe30 && c <= 0xfe6f) || (c >= 0xff00 && c <= 0xff60) ||
                    (c >= 0x1f300 && c <= 0x1faff) || (c >= 0x20000 && c <= 0x3fffd);
  return wide ? 2 : 1;
}

std::string escaped(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  return out;
}

}  // namespace

character take_character(std::string_view& text) {
  using utf8 = boost::locale::utf::utf_traits<char>;
  auto next = text.begin();
  const auto point = utf8::decode(next, text.end());
  const bool valid = point != boost::locale::utf::illegal && point != boost::locale::utf::incomplete;
  const auto bytes = text.substr(0, valid ? static_cast<std::size_t>(next - text.begin()) : 1);
  text.remove_prefix(bytes.size());
  return {bytes, static_cast<char32_t>(point), valid};
}

bool is_plain_text(std::string_view text) {
  while (!text.empty()) {
    const auto c = take_character(text);
    if (!c.valid || is_control(c.point)) return false;
  }
  return true;
}

std::string one_line(std::string_view text, std::size_t limit) {
  std::string out;
  std::size_t columns = 0, fits = 0;  // fits: bytes that leave room for the ellipsis
  while (!text.empty()) {
    const auto c = take_character(text);
    const bool space = is_space(c.bytes.front());
    if (space && (out.empty() || out.back() == ' ')) continue;
    const bool shown = c.valid && !is_control(c.point);
    const auto piece = space ? std::string{" "} : shown ? std::string{c.bytes} : escaped(c.bytes);
    columns += shown ? columns_of(c.point) : piece.size();
    if (columns > limit) return out.substr(0, fits) + "…";
    out += piece;
    if (columns < limit) fits = out.size();
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

std::size_t display_width(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const auto c = take_character(text);
    columns += c.valid ? columns_of(c.point) : 1;
  }
  return columns;
}

}  // namespace polhode
