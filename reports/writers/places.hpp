// Measurements of no scheme that stand at places: their observable says where, "a=1" or "a=1 b=2". Gathered into curves
// and maps. (Those of schemes: field.hpp.)
#pragma once

#include <string>
#include <vector>

#include "reports/model/results.hpp"
#include "reports/writers/svg_map.hpp"
#include "reports/writers/svg_plot.hpp"

namespace polhode::report {

/// One plot for each quantity over one coordinate; its unit names the ordinate.
std::vector<plot> place_curves_of(const results&, const std::string& experiment);

/// One map for each quantity over two coordinates, with the curves that lie in its plane drawn over it.
std::vector<value_map> place_maps_of(const results&, const std::string& experiment);

/// Numbers of the experiment that belong to no scheme, step size or place.
std::vector<const measurement*> facts_of(const results&, const std::string& experiment);

/// "λ₁" for "lambda_1", "σ" for "sigma", a blank for "_".
std::string as_written(std::string text);

}  // namespace polhode::report
