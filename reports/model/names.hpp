// SPDX-License-Identifier: Apache-2.0
// In which order every report shows experiments and schemes: declared ones first, then whatever else the results
// mention; no name twice.
#pragma once

#include <string>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode::report {

std::vector<std::string> experiment_names(const results&);
std::vector<std::string> scheme_names(const results&);

}  // namespace polhode::report
