// SPDX-License-Identifier: Apache-2.0
// Which numbers have changed beyond noise?
#pragma once

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode {

/// Appends the numbers that have changed, by the rules of compare.hpp, and counts those that were compared.
void compare_numbers(const report::results& before, const report::results& after, report::comparison& out);

}  // namespace polhode
