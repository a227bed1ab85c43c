// SPDX-License-Identifier: Apache-2.0
// The verdicts as a JUnit file: one suite an experiment, one case a verdict. Inconclusive is a failure, not a pass.
#pragma once

#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

std::string to_junit(const results&);

}  // namespace polhode::report
