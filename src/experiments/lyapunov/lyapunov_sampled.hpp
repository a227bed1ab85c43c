// SPDX-License-Identifier: Apache-2.0
// Lyapunov exponents of the discretisations: sampled growth of the tangents of their own steps, against the exact
// exponents of the equation.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/lyapunov/sampled_growth.hpp"
#include "sphere/lyapunov.hpp"

namespace polhode {

/// The step at which exponents are compared: 128 steps per fastest time scale.
double compared_step(const subject&);

using known_growths = std::vector<std::optional<discretisation_growth>>;  ///< [scheme]

/// For each scheme, all of which keep the sphere: lambda_1 and lambda_1 + lambda_2 at one small dt, each with a verdict
/// against the exact value. Where the exact values are not known nothing is compared. ask: of each scheme, what is
/// known of it; such a scheme is judged by that, and shorter paths say whether they grow so. Empty: of none.
void report_sampled_exponents(const context&, const std::vector<scheme_entry>&, const lyapunov_exponents& exact,
                              report::results&, const std::function<known_growths()>& ask = {});

}  // namespace polhode
