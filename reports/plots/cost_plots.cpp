// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/builders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include "reports/model/finite.hpp"
#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

constexpr std::array<std::string_view, 2> counts{"steps_per_time", "normals_per_time"};

/// The same points in another measure of cost.
series_id with_quantity(series_id of, std::string_view quantity) {
  of.quantity = quantity;
  return of;
}

/// What no machine changes; nobody has looked for a front there.
void add_counted(plot_description& p, const findings& found, std::string_view quantity) {
  plot_alternative other;
  for (const auto& line : p.lines) {
    const auto counted = with_quantity(line.series, quantity);
    const auto row = std::ranges::find_if(
        found.rows, [&](const measurement* m) { return belongs(*m, counted) && finite(m->value) && *m->value > 0; });
    if (row == found.rows.end()) continue;
    auto beside = line.beside;
    std::ranges::replace(beside, counted, line.series);
    other.lines.push_back({.series = counted, .across = line.across, .beside = std::move(beside)});
    if (!other.name.empty()) continue;
    other.name = quantity.substr(0, quantity.find('_'));
    other.title = fmt::format("{}, in {}", p.title, (*row)->unit);
    other.y_title = with_unit("cost", (*row)->unit);
  }
  if (!other.lines.empty()) p.others.push_back(std::move(other));
}

plot_description front_of(const findings& found, const row_list& costs, const measurement& error) {
  const auto& first = *costs.front();
  plot_description p{.id = slug({found.experiment, "cost", first.observable}),
                     .experiment = found.experiment,
                     .kind = plot_kind::front,
                     .title = fmt::format("Cost against error: {}", first.observable),
                     .note = "Lower left is better.",
                     .of = first.observable,
                     .x_title = fmt::format("{} error [{}]", first.observable, error.unit),
                     .y_title = with_unit("cost", first.unit),
                     .log_x = true,
                     .log_y = true,
                     .hollow = "not on the Pareto front of times",
                     .lines = lines_of(found, costs)};
  for (auto& line : p.lines) {
    line.across = with_quantity(line.series, "error_at_cost");
    for (const auto& quantity : counts) line.beside.push_back(with_quantity(line.series, quantity));
  }
  for (const auto& quantity : counts) add_counted(p, found, quantity);
  return p;
}

plot_description reach_of(const findings& found, const row_list& rows) {
  const auto& of = rows.front()->observable;
  const auto costs = rows_where(rows, [](const measurement& m) { return m.quantity == "cost_to_reach"; });
  const auto& reached =
      **std::ranges::find_if(costs, [](const measurement* m) { return finite(m->value).has_value(); });
  const auto failed = costs.size() - values_of(costs).size();
  plot_description p{.id = slug({found.experiment, "reach", of}),
                     .experiment = found.experiment,
                     .kind = plot_kind::reach,
                     .title = fmt::format("Cost to reach an accuracy: {}", of),
                     .of = of,
                     .x = costs.front()->over,
                     .x_title = fmt::format("{} error to be reached", of),
                     .y_title = with_unit("cost", reached.unit),
                     .log_x = true,
                     .log_y = true,
                     .hollow = "not the cheapest",
                     .lines = lines_of(found, costs)};
  if (failed > 0)
    p.note =
        fmt::format("{} target{} not reached at the steps that were measured.", failed, failed == 1 ? " is" : "s are");
  for (auto& line : p.lines) {
    const auto next = with_quantity(line.series, "cost_of_next");
    if (std::ranges::any_of(rows, [&](const measurement* m) { return belongs(*m, next); })) line.beside = {next};
  }
  return p;
}

}  // namespace

std::vector<plot_description> front_plots(findings& found) {
  using place = std::tuple<std::string, std::string, std::optional<double>>;
  const auto place_of_cost = [](const measurement& m) { return place{m.observable, m.scheme, m.abscissa()}; };
  const auto with_value = [&](std::string_view quantity) {
    return rows_where(
        found.rows, [&](const measurement& m) { return m.quantity == quantity && finite(m.value) && abscissa_of(m); });
  };
  const auto errors = with_value("error_at_cost");
  std::set<place> known;
  for (const auto* m : errors) known.insert(place_of_cost(*m));
  auto costs = with_value("cost");
  std::erase_if(costs, [&](const measurement* m) { return !known.contains(place_of_cost(*m)); });
  std::vector<plot_description> plots;
  for (const auto& rows : grouped(costs, [](const measurement& m) { return m.observable; })) {
    const auto error = std::ranges::find_if(
        errors, [&](const measurement* m) { return place_of_cost(*m) == place_of_cost(*rows.front()); });
    plots.push_back(front_of(found, rows, **error));
    take(found, rows_where(found.rows, [&](const measurement& m) {
           return m.observable == rows.front()->observable && (m.quantity == "cost" || m.quantity == "error_at_cost" ||
                                                               std::ranges::find(counts, m.quantity) != counts.end());
         }));
  }
  return plots;
}

std::vector<plot_description> reach_plots(findings& found) {
  const auto priced = rows_where(found.rows, [](const measurement& m) {
    return (m.quantity == "cost_to_reach" || m.quantity == "cost_of_next") && abscissa_of(m);
  });
  std::vector<plot_description> plots;
  for (const auto& rows : grouped(priced, [](const measurement& m) { return m.observable; })) {
    const auto costs =
        rows_where(rows, [](const measurement& m) { return m.quantity == "cost_to_reach" && finite(m.value); });
    if (costs.empty()) continue;
    plots.push_back(reach_of(found, rows));
    take(found, rows);
  }
  return plots;
}

}  // namespace polhode::report
