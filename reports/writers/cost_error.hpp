// SPDX-License-Identifier: Apache-2.0
// Rows that say what an error costs: points of one against the other, and a table.
#pragma once

#include <string>
#include <vector>

#include "reports/model/plots.hpp"
#include "reports/model/results.hpp"
#include "reports/writers/plot.hpp"
#include "reports/writers/series.hpp"

namespace polhode::report {

/// Of a line of a front: cost over error, which pair by their step size.
std::vector<plot_point> cost_points(const rows_by_series&, const plot_line&);

/// "To reach this": the cheapest, and how the next one compares.
struct cost_line {
  std::string what;
  const measurement* cost = nullptr;
  const measurement* next = nullptr;  ///< null where no other scheme reaches it
};
std::vector<cost_line> cost_table_of(const results&, const std::string& experiment);

}  // namespace polhode::report
