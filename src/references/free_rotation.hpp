// SPDX-License-Identifier: Apache-2.0
// The free rigid body in closed form, by Jacobi's elliptic functions.
#pragma once

#include <array>

namespace polhode {

/// Pi(t) of Pi' = Pi x (Pi / I), any moments of inertia > 0, any Pi0, t >= 0. Source: Landau, Lifshitz, Mechanics,
/// section 37, eqs. (37.8)-(37.12); the separatrix and equal moments of inertia as its limits. Accurate to about 1e-13
/// |Pi0| while t |Pi0| / I is below 1e3.
std::array<double, 3> free_rotation(const std::array<double, 3>& inertia, const std::array<double, 3>& pi0, double t);

}  // namespace polhode
