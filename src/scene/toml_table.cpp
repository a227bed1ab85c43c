// SPDX-License-Identifier: Apache-2.0
#include "scene/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

// toml++ makes a table of each part of a dotted key, and each level of tables takes from the stack.
constexpr std::size_t most_parts = 16;

/// Behind the quoted text that begins there: of one line, or of many between three quotes.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool many_lines = text.substr(at).starts_with(three);
  const auto end = std::string_view(three).substr(0, many_lines ? 3 : 1);
  for (at += end.size(); at < text.size(); ++at) {
    if (text[at] == '\n' && !many_lines) return at;
    if (text.substr(at).starts_with(end)) return std::max(at + end.size(), text.find_first_not_of(quote, at));
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return text.size();
}

/// Where a key of more than most_parts ends, or npos.
std::size_t find_deep_key(std::string_view text) {
  std::size_t parts = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '#')
      at = std::min(text.find('\n', at), text.size());
    else if (c == '"' || c == '\'')
      at = end_of_quoted(text, at);
    else
      ++at;
    if (c == '.' && ++parts >= most_parts) return at;
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) parts = 0;
  }
  return std::string_view::npos;
}

std::string_view line_around(std::string_view text, std::size_t at) {
  const auto begin = text.substr(0, at).rfind('\n') + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::string_view line_of(std::string_view text, std::size_t number) {
  std::size_t begin = 0;
  while (--number > 0 && begin <= text.size()) begin = std::min(text.find('\n', begin), text.size()) + 1;
  return begin < text.size() ? line_around(text, begin) : std::string_view{};
}

struct plain_words {
  std::string_view said, fault, accepted;
};

constexpr std::string_view a_line = "lines such as theta = 0.5, inertia = [1, 2, 3], name = \"text\"";

/// What toml++ says in its own terms, of a parser.
constexpr std::string_view line_end = "'\\n'";
constexpr plain_words in_plain_words[] = {
    {"invalid utf-8", "a byte that is no UTF-8", "text in UTF-8"},
    {"maximum nested value", "lists or tables more than 256 deep", "[1, 2, 3], or [[1, 0, 0], [0, 1, 0]]"},
    {"not representable in 64 bits", "an integer beyond 64 bits", "the same with a point or an exponent, such as 1e20"},
    {"could not be interpreted", "a number beyond double precision", "up to 1.79e308 in size"},
    {"numeric value too long", "a number of more than 126 characters", "at most 17 digits, and an exponent"},
    {"exceeds length limit", "a number of more than 126 characters", "at most 17 digits, and an exponent"},
    {"after '\\r'", "a carriage return inside a line", "lines that end in \\n or \\r\\n"},
    {"could not determine value type", "a value that is no number and stands in no quotes", a_line},
};

/// A quote that nobody closed runs into the end of its line, which is a control character, too.
plain_words in_text(std::string_view line) {
  const auto is_control = [](char c) { return (c >= 0 && c < ' ' && c != '\t' && c != '\r') || c == 0x7f; };
  if (std::ranges::any_of(line, is_control)) return {"", "a control character in text", "text without"};
  return {"", "a quote is not closed in its line", a_line};
}

std::string told(std::string_view said, std::string_view line) {
  const auto as = [](const plain_words& words) { return fmt::format("{}; accepted: {}", words.fault, words.accepted); };
  for (const auto& words : in_plain_words)
    if (said.find(words.said) != said.npos) return as(words);
  if (said.find("string: ") != said.npos && said.find("control characters") != said.npos) return as(in_text(line));
  if (said.find("cannot redefine") != said.npos) return "a key that stands there already; accepted: each key once";
  if (said.starts_with("Error while parsing ")) said.remove_prefix(said.find(": ") + 2);
  const bool at_end = said.ends_with(line_end);
  if (at_end) said.remove_suffix(line_end.size());
  return fmt::format("{}{}; accepted: {}", one_line(said, 200), at_end ? " the end of the line" : "", a_line);
}

[[noreturn]] void refuse_line(std::string_view source, std::size_t number, std::string_view line,
                              std::string_view fault) {
  const auto shown = one_line(line, 60);
  throw input_error(fmt::format("{}:{}: {}{}not TOML: {}", source, number, shown, shown.empty() ? "" : ": ", fault));
}

/// 1.0 stays a number that is no integer.
std::string as_written(double x) {
  auto text = fmt::format("{}", x);
  return text.find_first_not_of("-0123456789") == text.npos ? text + ".0" : text;
}

}  // namespace

toml::table toml_table(std::string_view text, std::string_view source) {
  if (const auto deep = find_deep_key(text); deep != text.npos)
    refuse_line(source, 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, deep), '\n')),
                line_around(text, deep),
                fmt::format("a key of more than {} parts; accepted: keys without points", most_parts));
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& fault) {
    const auto number = fault.source().begin.line;
    const auto line = line_of(text, number);
    refuse_line(source, number, line, told(fault.description(), line));
  }
}

std::optional<std::string> text_in(const toml::node& node) { return node.value_exact<std::string>(); }

std::optional<double> number_in(const toml::node& node) {
  double value = NAN;
  if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
  if (const auto* real = node.as_floating_point()) value = real->get();
  return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::optional<std::vector<double>> numbers_in(const toml::node& node) {
  const auto* array = node.as_array();
  if (array == nullptr) return {};
  std::vector<double> out;
  for (const auto& entry : *array) {
    const auto one = number_in(entry);
    if (!one) return {};
    out.push_back(*one);
  }
  return out;
}

std::optional<report::parameter> parameter_in(const toml::node& node) {
  if (const auto x = number_in(node)) return report::parameter{"", report::shape::number, {{*x}}};
  const auto* array = node.as_array();
  if (array == nullptr) return {};
  if (auto v = numbers_in(node); v && !v->empty()) return report::parameter{"", report::shape::vector, {*v}};
  report::parameter out{"", report::shape::vectors, {}};
  for (const auto& entry : *array) {
    auto one = numbers_in(entry);
    if (!one) return {};
    out.rows.push_back(*std::move(one));
  }
  return out;
}

std::string as_written(const toml::node& node) {
  if (const auto* real = node.as_floating_point()) return as_written(real->get());
  std::vector<std::string> inside;
  if (const auto* array = node.as_array()) {
    for (const auto& entry : *array) inside.push_back(as_written(entry));
    return fmt::format("[{}]", fmt::join(inside, ", "));
  }
  if (const auto* table = node.as_table()) {
    for (const auto& [key, entry] : *table) inside.push_back(fmt::format("{} = {}", key.str(), as_written(entry)));
    return fmt::format("{{{}}}", fmt::join(inside, ", "));
  }
  std::ostringstream text;
  node.visit([&](const auto& concrete) { text << concrete; });
  return text.str();
}

}  // namespace polhode
