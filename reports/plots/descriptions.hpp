// SPDX-License-Identifier: Apache-2.0
// Which plots and short tables there are of a result, and in which order: found from the shape of the measurements and
// not from the name of an experiment, so that a new experiment or quantity appears by itself.
#pragma once

#include <string>
#include <vector>

#include "reports/model/plots.hpp"
#include "reports/model/results.hpp"

namespace polhode::report {

std::vector<plot_description> plots_of(const results&);

/// Of one experiment.
std::vector<plot_description> plots_of(const results&, const std::string& experiment);

}  // namespace polhode::report
