// Measurements over dt and a second number: cells of a map, which no plot over dt may show.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reports/model/results.hpp"

namespace polhode::report {

/// "theta=0.5": the second number of a field, and its name.
struct coordinate {
  std::string name;
  double value = 0;
};
std::optional<coordinate> coordinate_of(std::string_view observable);

/// Whether a measurement is a cell of a map: it has a dt, and its observable is a coordinate.
bool in_field(const measurement&);

}  // namespace polhode::report
