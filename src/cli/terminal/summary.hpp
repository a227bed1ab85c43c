// SPDX-License-Identifier: Apache-2.0
// What is printed after a run: the verdicts of each experiment, and the claims that do not hold.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "reports/model/results.hpp"

namespace polhode::cli {

std::string summary(const report::results&, std::size_t width);

/// 1 if a claim is refuted, else 3 if one is inconclusive, else 0.
int exit_code(std::span<const report::results>);

}  // namespace polhode::cli
