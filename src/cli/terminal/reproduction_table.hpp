// SPDX-License-Identifier: Apache-2.0
// Reproductions for a terminal of some width.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "reports/model/reproduction.hpp"

namespace polhode::cli {

/// A table a case, and below it why a number differs.
std::string to_text(std::span<const report::reproduction>, std::size_t width);

/// 1 if a number should agree and does not, else 0.
int exit_code(std::span<const report::reproduction>);

}  // namespace polhode::cli
