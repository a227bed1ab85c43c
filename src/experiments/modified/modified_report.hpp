// SPDX-License-Identifier: Apache-2.0
// What is written of a scheme's modified equation: its parameters over dt, their distances from the scene's, the
// residual.
#pragma once

#include <vector>

#include "experiments/common/recorder.hpp"
#include "experiments/modified/modified_table.hpp"

namespace polhode {

/// The scene's own parameters, a level in each plot.
void report_own_parameters(const modified_columns&, recorder&);

/// Of one scheme, with the verdict on its residual. What the verdict on its parameters rests on.
std::vector<report::series_id> report_modified_equation(const modified_columns&, int order, const error_table&,
                                                        recorder&);

}  // namespace polhode
