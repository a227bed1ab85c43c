// SPDX-License-Identifier: Apache-2.0
// Reproductions for a reader of Markdown: a table of cases, then a table a case.
#pragma once

#include <span>
#include <string>

#include "reports/model/reproduction.hpp"

namespace polhode::report {

std::string to_markdown(std::span<const reproduction>);

}  // namespace polhode::report
