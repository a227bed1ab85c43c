// Lyapunov exponents of the schemes themselves: sampled growth of the tangents of their own steps, against the exact
// exponents of the equation.
#pragma once

#include "experiments/experiment.hpp"
#include "references/lyapunov.hpp"

namespace polhode {

/// For each scheme, all of which keep the sphere: lambda_1 and lambda_1 + lambda_2 at one small dt, each with a verdict
/// against the exact value. Where the exact values are not known nothing is compared.
void report_sampled_exponents(const context&, const std::vector<scheme_entry>&, const lyapunov_exponents& exact,
                              report::results&);

}  // namespace polhode
