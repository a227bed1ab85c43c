// SPDX-License-Identifier: Apache-2.0
// The measurements and the verdicts as tables for other programs (RFC 4180 quoting, one line a row).
#pragma once

#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

std::string measurements_csv(const results&);
std::string verdicts_csv(const results&);

}  // namespace polhode::report
