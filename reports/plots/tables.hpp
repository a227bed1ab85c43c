// SPDX-License-Identifier: Apache-2.0
// What is known without a scheme and drawn nowhere: of the scene, and of conditions.
#pragma once

#include <vector>

#include "reports/model/plots.hpp"
#include "reports/plots/findings.hpp"

namespace polhode::report {

std::vector<plot_description> fact_tables(findings&);

}  // namespace polhode::report
