// SPDX-License-Identifier: Apache-2.0
// Verdicts on a scheme's modified equation.
#pragma once

#include "experiments/modified/modified_table.hpp"

namespace polhode {

inline constexpr const char* parameters_claim = "parameters converge to the scene's";

/// Of that claim: differences and residual as power series in dt
/// (statistics/orders/power_series.hpp), whose coefficients below dt^order have to vanish. Refuted where an interval
/// excludes zero; holds where all include it and are narrower than a ten-thousandth of the parameter at the coarsest dt
/// (of the square of the residual: 1e-8, or 1e-5 of its largest value); else inconclusive.
report::verdict judge_parameters(const modified_columns&, const error_table&, int order);

}  // namespace polhode
