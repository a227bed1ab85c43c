// SPDX-License-Identifier: Apache-2.0
// Kernels that play a scheme's tapes on the face of a system.
#pragma once

#include <memory>

#include "ensemble/faces/face.hpp"
#include "ensemble/tangent_kernel.hpp"
#include "ensemble/tapes/tape.hpp"

namespace polhode {

/// tangents: the face on which tapes differentiate, of the same system and step size.
std::unique_ptr<kernel> tape_kernel(std::shared_ptr<const face> values, std::shared_ptr<const face> tangents,
                                    scheme_tapes);
/// The tapes are those of states with tangents.
std::unique_ptr<tangent_kernel> tape_tangent_kernel(std::shared_ptr<const face> tangents, scheme_tapes);

}  // namespace polhode
