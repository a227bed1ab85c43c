// Verdicts on a scheme's modified equation.
#pragma once

#include "experiments/modified_table.hpp"

namespace polhode {

/// "parameters converge to the scene's": differences and residual as power series in dt (statistics/power_series.hpp),
/// whose coefficients below dt^order have to vanish. Refuted where an interval excludes zero; holds where all include
/// it and are narrower than a ten-thousandth of the parameter at the coarsest dt; else inconclusive.
report::verdict judge_parameters(const modified_columns&, const error_table&, int order);

}  // namespace polhode
