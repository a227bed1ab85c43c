// SPDX-License-Identifier: Apache-2.0
// What a rigid body's kernel is chosen by.
#pragma once

#include <polhode/systems/rigid_body.hpp>
#include "systems/rigid_body/motion/body_parts.hpp"

namespace polhode {

/// The size of one step's rotations: the smallest whose bounds hold, the noise taken at 4.5 standard deviations (in
/// three dimensions one increment in 6000 is larger).
rotation_size rotation_size_of(const rigid_body&, double radius, double dt);

/// Two equal moments of inertia: the axis to be numbered 1 so that the odd one is 3. Otherwise 0.
int first_axis_of(const rigid_body&);

body_parts parts_of(const rigid_body&);

}  // namespace polhode
