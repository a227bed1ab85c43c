#include "cli/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <thread>

#include "reports/model/errors.hpp"
#include "scene/nearest.hpp"
#include "scene/text.hpp"

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
  if (!accepted) throw input_error(fmt::format("{} {}: accepted: {}", option, shown(text), what));
  return number(text);
}

}  // namespace

std::string shown(std::string_view text) { return fmt::format("'{}'", one_line(text, 60)); }

std::string default_threads() {
  return std::to_string(std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, most_threads));
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
    throw input_error(fmt::format("{} {}: accepted: an integer from {} to {}", option, shown(text), low, high));
  return value;
}

std::size_t choice_option(std::string_view option, std::string_view text, std::span<const std::string> accepted) {
  const auto found = std::ranges::find(accepted, text);
  if (found == accepted.end())
    throw input_error(fmt::format("{} {}: not known{}; accepted: {}", option, shown(text), did_you_mean(text, accepted),
                                  fmt::join(accepted, ", ")));
  return static_cast<std::size_t>(found - accepted.begin());
}

std::vector<std::string> list_option(std::string_view option, std::string_view text) {
  std::vector<std::string> out;
  for (std::string_view rest = text; !rest.empty();) {
    const auto item = rest.substr(0, rest.find(','));
    if (item.empty() || item.size() + 1 == rest.size())
      throw input_error(fmt::format("{} {}: an empty name; accepted: names separated by commas", option, shown(text)));
    if (std::ranges::find(out, item) == out.end()) out.emplace_back(item);
    rest.remove_prefix(std::min(item.size() + 1, rest.size()));
  }
  return out;
}

format format_option(std::string_view text) {
  static const std::vector<std::string> accepted{"text", "json"};
  return choice_option("--format", text, accepted) == 0 ? format::text : format::json;
}

}  // namespace polhode::cli
