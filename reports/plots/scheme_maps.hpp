// SPDX-License-Identifier: Apache-2.0
// Maps of schemes over dt and one more coordinate, a panel a scheme, with the border that was found for each value of
// that coordinate.
#pragma once

#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

/// Claims the cells; a border is a number of its own, too.
std::vector<plot_description> scheme_maps(findings&);

}  // namespace polhode::report
