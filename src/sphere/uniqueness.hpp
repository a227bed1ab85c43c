// SPDX-License-Identifier: Apache-2.0
// Whether a diffusion on the sphere has one stationary law, and what it conserves if not.
#pragma once

#include <string>

#include "sphere/sphere_problem.hpp"

namespace polhode {

/// Whether Pi along some axis, and functions of it, never change: one constant noise vector along an axis of revolution
/// of h without dissipation, or any one vector where h is constant. No other smooth function is conserved.
bool conserves_a_component(const sphere_problem& problem);

/// Whether the uniform law is stationary: no dissipation, and a noise that turns the sphere rigidly.
bool has_uniform_law(const sphere_problem& problem);

/// Why there is more than one stationary law; empty where no reason is known. One noise vector on an axis that is an
/// equilibrium leaves the state at rest there, so that a point mass is stationary too.
std::string no_unique_law(const sphere_problem& problem);

}  // namespace polhode
