// SPDX-License-Identifier: Apache-2.0
// Cost against error with the Pareto front, and what each accuracy costs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

std::vector<plot_description> front_plots(findings&);
std::vector<plot_description> reach_plots(findings&);

}  // namespace polhode::report
