// SPDX-License-Identifier: Apache-2.0
// Measurements gathered into series, and the description of a plot into what can be drawn.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/model/plots.hpp"
#include "reports/model/results.hpp"
#include "reports/writers/plot.hpp"

namespace polhode::report {

struct series {
  std::vector<const measurement*> rows;
  const measurement* first = nullptr;  ///< the first and the last that have a value
  const measurement* last = nullptr;
  std::size_t missing = 0;
};

/// In the order in which the results mention them. The pointers live as long as the results.
std::vector<series> series_of(const results&);

using rows_by_series = std::map<series_id, std::vector<const measurement*>>;

/// The plots of the experiment that are curves or fronts and have points.
std::vector<plot> drawable_plots(const results&, const std::string& experiment);

}  // namespace polhode::report
