#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr char32_t replacement = 0xFFFD;

int length_from(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

// Takes one code point off the front; a byte that starts none counts as one replacement character.
char32_t take(std::string_view& rest) {
  const auto lead = static_cast<unsigned char>(rest.front());
  const int length = length_from(lead);
  char32_t point = length <= 1 ? lead : lead & (0xFFu >> (length + 1));
  bool good = length > 0 && static_cast<std::size_t>(length) <= rest.size();
  for (int i = 1; good && i < length; ++i) {
    const auto next = static_cast<unsigned char>(rest[static_cast<std::size_t>(i)]);
    good = (next & 0xC0u) == 0x80u;
    point = (point << 6) | (next & 0x3Fu);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  good = good && point >= least[length] && point <= 0x10FFFF && !(point >= 0xD800 && point < 0xE000);
  rest.remove_prefix(good ? static_cast<std::size_t>(length) : 1);
  return good ? point : replacement;
}

void put(std::string& out, char32_t point) {
  const auto byte = [&](char32_t value) { out += static_cast<char>(static_cast<unsigned char>(value)); };
  if (point < 0x80) return byte(point);
  if (point < 0x800) {
    byte(0xC0 | (point >> 6));
  } else {
    if (point < 0x10000) {
      byte(0xE0 | (point >> 12));
    } else {
      byte(0xF0 | (point >> 18));
      byte(0x80 | ((point >> 12) & 0x3F));
    }
    byte(0x80 | ((point >> 6) & 0x3F));
  }
  byte(0x80 | (point & 0x3F));
}

template <class Map>
std::string mapped(std::string_view text, Map map) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) map(out, take(text));
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

std::string valid_utf8(std::string_view text) { return mapped(text, put); }

std::string printable(std::string_view text) {
  return mapped(text, [](std::string& out, char32_t point) { put(out, forbidden(point) ? replacement : point); });
}

std::string one_line(std::string_view text) {
  std::string out = printable(text);
  for (char& c : out)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  return out;
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
  const std::string clean = one_line(text);
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
  std::string_view rest = text;
  for (std::size_t count = 0; !rest.empty(); ++count) {
    const char32_t point = take(rest);
    if (count + 1 >= limit && !rest.empty()) return out + "…";
    put(out, point);
  }
  return out;
}

}  // namespace polhode::report
