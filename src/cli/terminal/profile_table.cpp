// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/profile_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "cli/terminal/layout.hpp"
#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

constexpr double worth_naming = 0.02;  // of the run

struct cost {
  std::string experiment;
  double seconds = 0;
  std::vector<report::profile_row> parts;
};

std::vector<cost> costs_of(std::span<const report::profile_row> rows) {
  std::vector<cost> all;
  for (const auto& row : rows) {
    const auto found = std::ranges::find(all, row.experiment, &cost::experiment);
    auto& one = found != all.end() ? *found : all.emplace_back(cost{row.experiment, 0, {}});
    one.seconds += row.cpu_seconds;
    one.parts.push_back(row);
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, &cost::seconds);
  for (auto& one : all) std::ranges::stable_sort(one.parts, std::ranges::greater{}, &report::profile_row::cpu_seconds);
  return all;
}

std::string parts_of(const cost& one, double total) {
  std::string out;
  for (const auto& part : one.parts)
    if (part.cpu_seconds >= worth_naming * total)
      out += fmt::format("{}{} {:.1f}", out.empty() ? "" : ", ", part.scheme.empty() ? "other" : part.scheme,
                         part.cpu_seconds);
  return out;
}

}  // namespace

std::string profile_table(std::span<const report::profile_row> rows, std::size_t width) {
  if (rows.empty()) return {};
  const auto all = costs_of(rows);
  double total = 0;
  std::size_t first = std::string_view{"experiment"}.size();
  for (const auto& one : all) {
    total += one.seconds;
    first = std::max(first, display_width(one.experiment));
  }
  auto out = fmt::format("{:<{}}  CPU s  share  of it\n", "experiment", first);
  for (const auto& one : all) {
    const auto line = fmt::format("{:<{}}  {:>5.1f}  {:>3.0f} %  ", one.experiment, first, one.seconds,
                                  100 * one.seconds / std::max(total, 1e-300));
    out += line + wrapped(parts_of(one, total), width, display_width(line), display_width(line)) + '\n';
  }
  return out;
}

}  // namespace polhode::cli
