// Measurements over dt and a second number, gathered into one map a scheme.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/results.hpp"
#include "reports/writers/heat_map.hpp"

namespace polhode::report {

/// "theta=0.5": the second number of a field, and its name.
struct coordinate {
  std::string name;
  double value = 0;
};
std::optional<coordinate> coordinate_of(std::string_view observable);

/// Whether a measurement is a cell of a map: it has a dt, and its observable is a coordinate.
bool in_field(const measurement&);

/// One for each scheme and quantity of the experiment. Its border: the scheme's rows at the same coordinates that are
/// times themselves and have no dt. All maps of a quantity have the same axes.
std::vector<heat_map> maps_of(const results&, const std::string& experiment);

}  // namespace polhode::report
