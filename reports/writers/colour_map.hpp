// SPDX-License-Identifier: Apache-2.0
// Colour maps that are evenly brighter from end to end, as polynomials.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/writers/raster.hpp"

namespace polhode::report {

struct colour_map {
  std::string_view name;
  double first;                                       ///< where it begins for densities: what is empty must be darker
  std::array<std::array<double, 7>, 3> coefficients;  ///< of red, green, blue, by rising power

  /// t in [0, 1]; within 3 % of the table that it is fitted to.
  colour at(double t) const;
};

/// viridis, magma, cividis. Source: matplotlib's tables (van der Walt, Smith: viridis, magma, CC0; Nunez, Anderton,
/// Renslow, PLOS ONE 13 (2018) e0199239: cividis, for all colour vision); polynomials of sixth degree by M. Zucker
/// (shadertoy WlfXRN, CC0) for the first two.
std::span<const colour_map> colour_maps();

/// In the order of colour_maps().
std::vector<std::string> colour_map_names();

}  // namespace polhode::report
