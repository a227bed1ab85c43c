// SPDX-License-Identifier: Apache-2.0
// Experiments in a form for schemes of which a step takes long, as those of interpreters do.
#pragma once

#include "experiments/common/experiment.hpp"

namespace polhode {

/// A tenth of the steps, taken on to a million as the drift grows.
experiment dear_casimir_experiment();
/// The scene alone: no parameter is moved, and no long run made.
experiment dear_stability_experiment();

}  // namespace polhode
