// The stationary law of every scheme that keeps the sphere, against the true one, without sampling.
#pragma once

#include "experiments/common/experiment.hpp"
#include "sphere/kolmogorov.hpp"

namespace polhode {

/// The true density on the unit sphere, in harmonics, of a rigid body: exp(-beta h) where the noise is isotropic (a
/// closed form), else what the Kolmogorov operator leaves as it is. Without a density or with a reason: not known.
stationary_law true_law(const subject&);

/// The same of any problem, to an accuracy in L2.
stationary_law law_of(const sphere_problem&, bool isotropic, double accuracy);

/// Near enough to what was asked for.
bool is_usable(const stationary_law&);

/// The part of experiment gibbs that rests on transfer.hpp: bias of every observable's mean and distance of the
/// densities over dt, and the order of the bias against the claimed weak order. Appends a skip where the true law is
/// not known.
void report_stationary_bias(const context&, report::results&);

}  // namespace polhode
