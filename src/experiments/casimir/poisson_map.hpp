// SPDX-License-Identifier: Apache-2.0
// Is a step without noise and dissipation a Poisson map?
//
// B(mu) is the Lie-Poisson bracket as a matrix, B(mu) xi = ad*_xi mu. A map f with Jacobian J is a Poisson map if
//
//   J B(mu) J^T = B(f(mu))
//
// for every mu, as the flow of any Hamiltonian is, and so any composition of such flows: Hairer, Lubich, Wanner,
// Geometric Numerical Integration (2006), VII.4. That is more than staying on the orbit: it is what makes the energy of
// a free body oscillate instead of drift. A scheme of deterministic order p whose step is none has a defect of dt^(p+1)
// at least, as its Jacobian differs by so little from that of the flow.
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

/// Largest |J B J^T - B(f)| / |B(f)| (Frobenius) of one step of dt over a block of states of Gaussian direction about
/// as long as the momentum, the same always; s: without noise and dissipation. NaN where a step is not finite.
double poisson_defect(const subject& s, const scheme_entry&, double dt);

/// Of the recorder's scheme. Where it claims it: the defect is rounding at every dt. Else the order of the defect.
void report_poisson_map(const context&, recorder&);

}  // namespace polhode
