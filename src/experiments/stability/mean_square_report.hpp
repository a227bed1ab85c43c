// SPDX-License-Identifier: Apache-2.0
// What is said of mean squares beside the equilibria: rates of growth, their errors and the order.
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

/// Of no scheme: the rates of the equation.
void report_true_growth(const subject&, recorder&);

/// Of the recorder's scheme: rates and their errors at each equilibrium, the largest dt up to which equation and scheme
/// agree on stability, and the order of the errors. Nothing where no noise acts along any of them.
void report_mean_square(const context&, recorder&);

}  // namespace polhode
