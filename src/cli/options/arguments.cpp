// SPDX-License-Identifier: Apache-2.0
#include "cli/options/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <thread>

#include "cli/together.hpp"
#include "reports/model/text.hpp"
#include "scene/nearest.hpp"

namespace polhode::cli {
namespace {

constexpr std::uint64_t most_threads = 1024;

/// Not a number: text that is none.
double number(std::string_view text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = fault == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

double checked_number(std::string_view option, std::string_view text, bool accepted, std::string_view what) {
  if (!accepted) refuse(option, text, fmt::format("accepted: {}", what));
  return number(text);
}

}  // namespace

std::string shown(std::string_view text) { return fmt::format("'{}'", one_line(text, 60)); }

std::string default_threads() {
  const auto share = std::thread::hardware_concurrency() / static_cast<unsigned>(processes_here());
  return std::to_string(std::clamp<std::uint64_t>(share, 1, most_threads));
}

int threads_option(std::string_view text) {
  return static_cast<int>(integer_option("--threads", text, 1, most_threads));
}

double positive_option(std::string_view option, std::string_view text) {
  return checked_number(option, text, number(text) > 0, "a number above 0");
}

double nonnegative_option(std::string_view option, std::string_view text) {
  return checked_number(option, text, number(text) >= 0, "a number of at least 0");
}

std::uint64_t integer_option(std::string_view option, std::string_view text, std::uint64_t low, std::uint64_t high) {
  std::uint64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = fault == std::errc{} && end == text.data() + text.size();
  if (!whole || value < low || value > high)
    refuse(option, text, fmt::format("accepted: an integer from {} to {}", low, high));
  return value;
}

std::vector<std::string> list_option(std::string_view option, std::string_view text) {
  std::vector<std::string> out;
  for (std::string_view rest = text; !rest.empty();) {
    const auto item = rest.substr(0, rest.find(','));
    if (item.empty() || item.size() + 1 == rest.size())
      refuse(option, text, "an empty name; accepted: names separated by commas");
    if (std::ranges::find(out, item) == out.end()) out.emplace_back(item);
    rest.remove_prefix(std::min(item.size() + 1, rest.size()));
  }
  return out;
}

format format_option(std::string_view text) {
  static const std::vector<std::string> accepted{"text", "json"};
  return choose("--format", text, accepted) == 0 ? format::text : format::json;
}

}  // namespace polhode::cli
