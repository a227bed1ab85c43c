// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/builders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

bool is_cell(const measurement& m) { return !m.scheme.empty() && m.over == step_size && place_of(m).size() == 1; }

/// A step size that was found at a value of the same coordinate.
std::optional<series_id> border_series(const findings& found, const std::string& scheme,
                                       const std::string& coordinate) {
  const auto row = std::ranges::find_if(found.rows, [&](const measurement* m) {
    return m->scheme == scheme && m->over.empty() && m->unit == "time" && m->at.size() == 1 &&
           m->at.front().name == coordinate;
  });
  return row == found.rows.end() ? std::nullopt : std::optional((*row)->series());
}

plot_description scheme_map(const findings& found, const row_list& rows) {
  const auto& first = *rows.front();
  const auto parameter = place_of(first).front().name;
  plot_description p{.id = slug({found.experiment, first.quantity}),
                     .experiment = found.experiment,
                     .kind = plot_kind::map,
                     .title = fmt::format("{} over {} and {}", first.quantity, step_size, parameter),
                     .x = step_size,
                     .y = parameter,
                     .x_title = step_size,
                     .y_title = parameter,
                     .value_title = first.quantity,
                     .log_x = true,
                     .log_y = true,
                     .border_across = true,
                     .lines = lines_of(found, rows)};
  p.note =
      "×: crossed for the reason that its tooltip gives. Empty: not tried. Line: the border by bisection; ▶ nothing "
      "tried lies beyond it, ◀ everything does.";
  for (auto& line : p.lines) {
    line.border = border_series(found, line.series.scheme, parameter);
    if (line.border && p.border_title.empty()) p.border_title = line.border->quantity;
  }
  return p;
}

}  // namespace

std::vector<plot_description> scheme_maps(findings& found) {
  std::vector<plot_description> plots;
  const auto cells = rows_where(found.rows, is_cell);
  for (const auto& rows :
       grouped(cells, [](const measurement& m) { return std::pair(m.quantity, place_of(m).front().name); }))
    if (!values_of(rows).empty()) {
      plots.push_back(scheme_map(found, rows));
      take(found, rows);
    }
  return plots;
}

}  // namespace polhode::report
