// SPDX-License-Identifier: Apache-2.0
// The Gibbs law of a body by Gauss-Legendre quadrature in long double, about the axis of greatest energy.
#pragma once

#include <array>

namespace polhode::test {

/// E[Pi_k^2] of the axes in order of increasing inertia, and of h above its least, about the axis of greatest energy.
std::array<double, 4> gibbs_about_the_other_axis(std::array<double, 3> inertia, double c, double beta);

}  // namespace polhode::test
