// SPDX-License-Identifier: Apache-2.0
// The stationary law of schemes that keep the sphere, sampled at one small dt.
//
// Independent paths start uniformly on the sphere, forget their start, and are then observed at several times. The mean
// over the times of one path is one sample, so the interval over paths knows the autocorrelation without estimating it.
#pragma once

#include "experiments/common/experiment.hpp"

namespace polhode {

/// Means of the energy and of squares of the momentum, and the law of the energy, against the Gibbs law. Skipped where
/// no law is claimed, open where forgetting the start takes too many steps.
void report_sampled_law(const context&, report::results&);

}  // namespace polhode
