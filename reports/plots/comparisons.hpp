// SPDX-License-Identifier: Apache-2.0
// Numbers of schemes that belong to no abscissa: beside each other, or schemes x conditions.
#pragma once

#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

/// One value a scheme.
plot_description comparison_of(const findings&, const row_list&);

/// A comparison for each quantity; a matrix where it was measured under several conditions.
std::vector<plot_description> standing_values(findings&);

}  // namespace polhode::report
