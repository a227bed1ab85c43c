// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/cost_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reports/model/finite.hpp"

namespace polhode::report {

std::vector<plot_point> cost_points(const rows_by_series& all, const plot_line& line) {
  std::vector<plot_point> points;
  for (const auto* error : all.at(*line.across))
    for (const auto* cost : all.at(line.series)) {
      if (error->abscissa() != cost->abscissa() || !finite(error->value) || !finite(cost->value)) continue;
      points.push_back({*error->value, *cost->value, finite(cost->low), finite(cost->high), cost->used});
    }
  return points;
}

std::vector<cost_line> cost_table_of(const results& r, const std::string& experiment) {
  std::vector<cost_line> lines;
  for (const auto& m : r.measurements)
    if (m.experiment == experiment && m.quantity == "cost_to_reach" && m.used)
      lines.push_back({fmt::format("{} {:.0e}", m.observable, m.abscissa().value_or(0)), &m});
  for (const auto& m : r.measurements) {
    if (m.experiment != experiment || m.quantity != "cost_of_next") continue;
    for (auto& line : lines)
      if (line.cost->scheme == m.scheme && line.cost->observable == m.observable &&
          line.cost->abscissa() == m.abscissa())
        line.next = &m;
  }
  std::ranges::sort(lines, [](const cost_line& a, const cost_line& b) {
    return std::pair(a.cost->observable, b.cost->abscissa()) < std::pair(b.cost->observable, a.cost->abscissa());
  });
  return lines;
}

}  // namespace polhode::report
