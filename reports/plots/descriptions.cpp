// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/descriptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "reports/model/finite.hpp"
#include "reports/model/names.hpp"
#include "reports/model/plots.hpp"
#include "reports/plots/builders.hpp"
#include "reports/plots/findings.hpp"
#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

// What is known without a scheme and drawn nowhere: of the scene, and of conditions.

void add(std::vector<plot_description>& tables, findings& found, plot_kind kind, const row_list& rows) {
  if (rows.empty()) return;
  const std::string name(name_of(kind));
  tables.push_back({.id = slug({found.experiment, name}),
                    .experiment = found.experiment,
                    .kind = kind,
                    .title = name,
                    .conditions = conditions_of(rows),
                    .lines = lines_of(found, rows)});
  take(found, rows);
}

std::vector<plot_description> fact_tables(findings& found) {
  const auto of_none = [](const measurement& m) { return m.scheme.empty() && !abscissa_of(m); };
  const auto is_fact = [&](const measurement& m) { return of_none(m) && condition_of(m) == condition{}; };
  const auto is_known = [&](const measurement& m) {
    return of_none(m) && condition_of(m) != condition{} && finite(m.value);
  };
  std::vector<plot_description> tables;
  add(tables, found, plot_kind::facts, rows_where(found.rows, is_fact));
  add(tables, found, plot_kind::conditions, rows_where(found.rows, is_known));
  return tables;
}

// The first that a measurement fits claims it; what none of them wants stands in the table of all measurements.
using builder = std::vector<plot_description>(findings&);
constexpr builder* builders[] = {scheme_maps,    front_plots,     reach_plots, curve_plots,
                                 equation_plots, standing_values, fact_tables};

void make_unique(std::vector<plot_description>& plots) {
  std::set<std::string> known;
  for (auto& plot : plots) {
    const auto id = plot.id;
    for (int i = 2; !known.insert(plot.id).second; ++i) plot.id = fmt::format("{}.{}", id, i);
  }
}

}  // namespace

std::vector<plot_description> plots_of(const results& r, const std::string& experiment) {
  auto found = findings_of(r, experiment);
  std::vector<plot_description> plots;
  for (const auto build : builders) std::ranges::move(build(found), std::back_inserter(plots));
  make_unique(plots);
  return plots;
}

std::vector<plot_description> plots_of(const results& r) {
  std::vector<plot_description> plots;
  for (const auto& name : experiment_names(r)) std::ranges::move(plots_of(r, name), std::back_inserter(plots));
  make_unique(plots);
  return plots;
}

}  // namespace polhode::report
