// SPDX-License-Identifier: Apache-2.0
// The report for a reader in a terminal or a code review: the verdict first, then the boards, the fits, the rest.
#pragma once

#include <string>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode::report {

/// Always under a megabyte: what would not fit is cut at a line, and the text says so.
std::string to_markdown(const results&);

/// A row of a table, and the row at its head: cells that are safe there.
void append_table_row(std::string& out, const std::vector<std::string>& cells);
void append_table_head(std::string& out, const std::vector<std::string>& cells);

}  // namespace polhode::report
