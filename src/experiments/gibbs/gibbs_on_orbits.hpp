// SPDX-License-Identifier: Apache-2.0
// The stationary law of systems that do not live on a sphere, sampled at one small dt against the means that the system
// knows of its Gibbs law.
//
// Independent paths, half of them from the scene's momentum and half from all over the orbit, forget their start
// (relaxation.hpp) and are averaged in time. The time average of a path is one sample, so that the interval over paths
// knows the autocorrelation without estimating it.
#pragma once

#include <cstddef>

#include "experiments/common/experiment.hpp"

namespace polhode {

inline constexpr std::size_t averaged_components = 6;  ///< of a long state the first

/// Means of the energy, the components and their squares of the schemes that keep the orbit, and the whole law of what
/// the system knows it of. Skipped where the system knows no law, open where forgetting the start
/// takes too many steps.
void report_sampled_means(const context&, report::results&);

}  // namespace polhode
