// SPDX-License-Identifier: Apache-2.0
// The stationary law of the equation itself, in closed form where there is one.
#pragma once

#include "problem/subject.hpp"
#include "sphere/stationary.hpp"

namespace polhode {

/// The true density on the unit sphere, in harmonics, of a rigid body: exp(-beta h) where the noise is isotropic (a
/// closed form), else what the Kolmogorov operator leaves as it is. Without a density or with a reason: not known.
stationary_law true_law(const subject&);

/// The same of any problem, to an accuracy in L2.
stationary_law law_of(const sphere_problem&, bool isotropic, double accuracy);

/// Near enough to what was asked for.
bool is_usable(const stationary_law&);

}  // namespace polhode
