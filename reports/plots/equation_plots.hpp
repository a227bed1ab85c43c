// SPDX-License-Identifier: Apache-2.0
// What is known of the equation itself at places of its parameter space, apart from any scheme: curves over one
// parameter, maps over two.
#pragma once

#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

/// Of numbers with an interval: one without is a setting and no result.
std::vector<plot_description> equation_plots(findings&);

}  // namespace polhode::report
