// SPDX-License-Identifier: Apache-2.0
// Which claims are decided otherwise?
#pragma once

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode {

/// Appends the claims whose verdict has changed, and those that held and are no longer made of an experiment and scheme
/// that were run again; counts those that were compared.
void compare_claims(const report::results& before, const report::results& after, report::comparison& out);

}  // namespace polhode
