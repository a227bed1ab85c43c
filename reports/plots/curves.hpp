// SPDX-License-Identifier: Apache-2.0
// Values over dt, over numbers of steps or over any other abscissa, a line a scheme.
#pragma once

#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

/// Also the numbers of the same quantity that belong to no abscissa, as levels. Where each scheme has one value only:
/// a comparison.
std::vector<plot_description> curve_plots(findings&);

}  // namespace polhode::report
