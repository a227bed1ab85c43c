// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/forecast_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "cli/terminal/layout.hpp"
#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

constexpr double is_long = 60;  // seconds on the clock

double total_of(std::span<const expected_cost> costs) {
  double total = 0;
  for (const auto& one : costs) total += one.cpu_seconds;
  return total;
}

std::vector<expected_cost> dearest_first(std::span<const expected_cost> costs) {
  std::vector<expected_cost> sorted(costs.begin(), costs.end());
  std::ranges::stable_sort(sorted, std::ranges::greater{}, &expected_cost::cpu_seconds);
  return sorted;
}

/// With the two digits that a forecast has.
std::string about(double seconds) {
  const auto in = [](double value, std::string_view unit) {
    return fmt::format("{:.{}f} {}", value, value < 9.95 ? 1 : 0, unit);
  };
  if (seconds < 1) return "below 1 s";
  if (seconds < 99.5) return in(seconds, "s");
  return seconds < 99.5 * 60 ? in(seconds / 60, "min") : in(seconds / 3600, "h");
}

std::string whole_of(std::string_view scene, std::span<const expected_cost> costs, int threads) {
  return fmt::format("{}: about {} on {} thread{}", one_line(scene, 60), about(total_of(costs) / threads), threads,
                     threads == 1 ? "" : "s");
}

}  // namespace

std::string forecast_table(std::string_view scene, std::span<const expected_cost> costs, int threads,
                           std::size_t width) {
  std::size_t first = std::string_view{"experiment"}.size();
  for (const auto& one : costs) first = std::max(first, display_width(one.experiment));
  auto out = fmt::format("{:<{}}  expected CPU time\n", "experiment", first);
  for (const auto& one : dearest_first(costs))
    out += fmt::format("{:<{}}  {}\n", one.experiment, first, one.cpu_seconds > 0 ? about(one.cpu_seconds) : "none");
  return out + wrapped(whole_of(scene, costs, threads), width) + '\n';
}

std::string long_run_note(std::string_view scene, std::span<const expected_cost> costs, int threads,
                          std::size_t width) {
  if (total_of(costs) / threads < is_long) return {};
  constexpr double worth_naming = 0.1;
  auto out = whole_of(scene, costs, threads);
  auto lead = ": ";
  for (const auto& one : dearest_first(costs)) {
    if (one.cpu_seconds < worth_naming * total_of(costs)) break;
    out += fmt::format("{}{} {}", lead, one.experiment, about(one.cpu_seconds / threads));
    lead = ", ";
  }
  return wrapped(out + " (--budget ends it in time)", width, 2) + '\n';
}

}  // namespace polhode::cli
