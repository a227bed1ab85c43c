// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/builders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "reports/model/finite.hpp"
#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

bool has_interval(const measurement& m) { return finite(m.low) || finite(m.high); }

std::vector<row_list> groups_of(const findings& found, std::size_t coordinates) {
  const auto placed = rows_where(found.rows, [&](const measurement& m) {
    return m.scheme.empty() && m.over.empty() && place_of(m).size() == coordinates;
  });
  auto groups = grouped(placed, [](const measurement& m) { return std::pair(m.quantity, place_names(m)); });
  std::erase_if(groups, [](const row_list& rows) {
    const auto is_setting = [](const measurement* m) { return finite(m->value) && !has_interval(*m); };
    return std::ranges::any_of(rows, is_setting) ||
           std::ranges::none_of(rows, [](const measurement* m) { return has_interval(*m); });
  });
  return groups;
}

bool log_over(const row_list& rows, const std::string& coordinate) {
  std::vector<double> values;
  for (const auto* m : rows)
    if (const auto at = finite(m->at_coordinate(coordinate))) values.push_back(*at);
  return spans(values, wide_for_steps);
}

plot_description equation_curve(const findings& found, const row_list& rows) {
  const auto& first = *rows.front();
  const auto x = place_names(first).front();
  return {.id = slug({found.experiment, first.quantity}),
          .experiment = found.experiment,
          .kind = plot_kind::curve,
          .title = fmt::format("{}: {} over {}", first.quantity, first.unit, x),
          .note = missing_in(rows),
          .x = x,
          .x_title = x,
          .y_title = first.unit,
          .log_x = log_over(rows_where(rows, [](const measurement& m) { return finite(m.value).has_value(); }), x),
          .lines = lines_of(found, rows)};
}

/// A curve belongs on a map where it gives the map's second coordinate over its first.
const measurement* border_curve(const std::vector<row_list>& curves, const std::string& x, const std::string& y) {
  const auto curve = std::ranges::find_if(
      curves, [&](const row_list& rows) { return place_names(*rows.front()).front() == x && rows.front()->unit == y; });
  return curve == curves.end() || values_of(*curve).empty() ? nullptr : curve->front();
}

std::string note_of(const std::string& value, const std::string& border, const row_list& rows) {
  std::string note = fmt::format("Warm: {} is positive; cool: negative.", value);
  if (!border.empty()) note += fmt::format(" Line: {}.", border);
  if (const auto missing = missing_in(rows); !missing.empty()) note += " " + missing;
  return note;
}

plot_description equation_map(const findings& found, const row_list& rows, const std::vector<row_list>& curves) {
  const auto& first = *rows.front();
  const auto names = place_names(first);
  auto value = first.quantity;
  if (constexpr std::string_view ending = " map"; value.ends_with(ending)) value.resize(value.size() - ending.size());
  const auto* border = border_curve(curves, names[0], names[1]);
  plot_description p{.id = slug({found.experiment, first.quantity}),
                     .experiment = found.experiment,
                     .kind = plot_kind::map,
                     .title = fmt::format("{} over {} and {}", value, names[0], names[1]),
                     .note = note_of(value, border ? border->quantity : "", rows),
                     .x = names[0],
                     .y = names[1],
                     .x_title = names[0],
                     .y_title = names[1],
                     .value_title = with_unit(value, first.unit),
                     .border_title = border ? border->quantity : "",
                     .log_x = log_over(rows, names[0]),
                     .log_y = log_over(rows, names[1]),
                     .diverging = true,
                     .lines = lines_of(found, rows)};
  if (border) p.lines.front().border = border->series();
  return p;
}

}  // namespace

std::vector<plot_description> equation_plots(findings& found) {
  const auto curves = groups_of(found, 1), maps = groups_of(found, 2);
  std::vector<plot_description> plots;
  for (const auto& rows : maps) plots.push_back(equation_map(found, rows, curves));
  for (const auto& rows : curves) plots.push_back(equation_curve(found, rows));
  for (const auto* groups : {&curves, &maps})
    for (const auto& rows : *groups) take(found, rows);
  return plots;
}

}  // namespace polhode::report
