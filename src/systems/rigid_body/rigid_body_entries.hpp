// SPDX-License-Identifier: Apache-2.0
// What is compiled of the rigid body for each instruction set beside its plain faces: the face that is bound to a step
// size and to the orbit of a radius, and the kernels of some schemes; null where a scheme has none.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <polhode/systems/rigid_body.hpp>

#include "ensemble/faces/face.hpp"
#include "ensemble/kernel.hpp"
#include "platform/isa_entry.hpp"

POLHODE_DECLARE_ENTRIES(polhode_rigid_body_face_, const polhode::rigid_body&, double, double,
                        std::shared_ptr<const polhode::face>&);
POLHODE_DECLARE_ENTRIES(polhode_rigid_body_kernel_, std::string_view, const polhode::rigid_body&,
                        std::span<const double>, double, std::unique_ptr<polhode::kernel>&);
