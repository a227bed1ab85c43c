// Measurements gathered into series (one scheme, one quantity, one observable) and series into plots.
#pragma once

#include <string>
#include <vector>

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

/// One plot for each (quantity, observable) of the experiment that has an abscissa, one line a scheme; not of the
/// cells of maps (field.hpp).
std::vector<plot> plots_of(const results&, const std::string& experiment);

}  // namespace polhode::report
