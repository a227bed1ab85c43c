// SPDX-License-Identifier: Apache-2.0
// The report for a reader in a terminal or a code review: the verdict first, then the boards, the fits, the rest.
#pragma once

#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

/// Always under a megabyte: what would not fit is cut at a line, and the text says so.
std::string to_markdown(const results&);

}  // namespace polhode::report
