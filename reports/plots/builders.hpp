// SPDX-License-Identifier: Apache-2.0
// The builders of plots. Each takes from the findings of an experiment the rows that it shows, and claims them.
#pragma once

#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

/// Maps of schemes over dt and one more coordinate, a panel a scheme, with the border that was found for each value of
/// that coordinate. Claims the cells; a border is a number of its own, too.
std::vector<plot_description> scheme_maps(findings&);

/// Cost against error with the Pareto front.
std::vector<plot_description> front_plots(findings&);
/// What each accuracy costs.
std::vector<plot_description> reach_plots(findings&);

/// Values over dt, over numbers of steps or over any other abscissa, a line a scheme; and the numbers of the same
/// quantity that belong to no abscissa, as levels. Where each scheme has one value only: a comparison.
std::vector<plot_description> curve_plots(findings&);

/// What is known of the equation itself at places of its parameter space, apart from any scheme: curves over one
/// parameter, maps over two. Of numbers with an interval: one without is a setting and no result.
std::vector<plot_description> equation_plots(findings&);

/// One value a scheme.
plot_description comparison_of(const findings&, const row_list&);
/// A comparison for each quantity; a matrix where it was measured under several conditions.
std::vector<plot_description> standing_values(findings&);

}  // namespace polhode::report
