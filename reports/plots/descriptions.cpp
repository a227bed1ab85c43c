// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/descriptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "reports/model/names.hpp"
#include "reports/plots/comparisons.hpp"
#include "reports/plots/cost_plots.hpp"
#include "reports/plots/curves.hpp"
#include "reports/plots/equation_plots.hpp"
#include "reports/plots/findings.hpp"
#include "reports/plots/scheme_maps.hpp"
#include "reports/plots/tables.hpp"

namespace polhode::report {
namespace {

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
