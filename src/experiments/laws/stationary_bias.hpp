// SPDX-License-Identifier: Apache-2.0
// The stationary law of every scheme that keeps the sphere, against the true one, without sampling.
#pragma once

#include "experiments/common/experiment.hpp"

namespace polhode {

/// The part of experiment gibbs that rests on transfer.hpp: bias of every observable's mean and distance of the
/// densities over dt, and the order of the bias against the claimed weak order. Appends a skip where the true law is
/// not known.
void report_stationary_bias(const context&, report::results&);

}  // namespace polhode
