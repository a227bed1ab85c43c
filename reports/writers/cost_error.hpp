// Rows that say what an error costs, gathered into plots of one against the other and into a table.
#pragma once

#include <string>
#include <vector>

#include "reports/model/results.hpp"
#include "reports/writers/plot.hpp"

namespace polhode::report {

/// Whether a row belongs to these pictures and not to one over its step size.
bool says_cost(const measurement&);

/// One plot for each observable of the quantities "cost" and "error_at_cost", which pair by scheme and dt.
std::vector<plot> cost_plots_of(const results&, const std::string& experiment);

/// "To reach this": the cheapest, and how the next one compares.
struct cost_line {
  std::string what;
  const measurement* cost = nullptr;
  const measurement* next = nullptr;  ///< null where no other scheme reaches it
};
std::vector<cost_line> cost_table_of(const results&, const std::string& experiment);

}  // namespace polhode::report
