#include "cli/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <thread>

#include "registry/nearest.hpp"
#include "registry/text.hpp"
#include "reports/model/errors.hpp"

namespace polhode::cli {
namespace {

constexpr std::uint64_t most_threads = 1024;

std::string shown(std::string_view text) { return fmt::format("'{}'", one_line(text, 60)); }

std::vector<std::string> long_options_of(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const auto* option : parser.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// What the parser left over, without the mark that ends the options.
std::vector<std::string> rest_of(const CLI::App& parser) {
  auto rest = parser.remaining();
  std::erase(rest, "--");
  return rest;
}

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

void refuse_rest(const CLI::App& parser) {
  const auto rest = rest_of(parser);
  if (rest.empty()) return;
  const auto argument = rest.front().substr(0, rest.front().find('='));
  if (!argument.starts_with('-'))
    throw input_error(fmt::format("{} is one argument too many for {}", shown(argument), parser.get_name()));
  const auto known = long_options_of(parser);
  // One letter is near to any other.
  const auto hint = argument.size() > 2 ? did_you_mean(argument, known) : "";
  throw input_error(fmt::format("{}: unknown option{}; accepted: {}", shown(argument), hint, fmt::join(known, ", ")));
}

}  // namespace

void refuse_unknown(const CLI::App& root, std::span<const command> commands) {
  std::vector<std::string> names;
  for (const auto& c : commands) names.push_back(c.parser->get_name());
  const auto rest = rest_of(root);
  if (!rest.empty() && !rest.front().starts_with('-') && root.get_subcommands().empty())
    throw input_error(fmt::format("{}: unknown command{}; accepted: {}", shown(rest.front()),
                                  did_you_mean(rest.front(), names), fmt::join(names, ", ")));
  refuse_rest(root);
  for (const auto* parser : root.get_subcommands()) refuse_rest(*parser);
  if (root.get_subcommands().empty())
    throw input_error(fmt::format("no command given; accepted: {}; see polhode --help", fmt::join(names, ", ")));
}

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
