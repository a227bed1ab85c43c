// SPDX-License-Identifier: Apache-2.0
// The rigid body's kernels beside its faces, of each instruction set; null where a scheme has none.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <polhode/systems/rigid_body.hpp>

#include "ensemble/kernel.hpp"
#include "platform/isa_entry.hpp"

POLHODE_DECLARE_ENTRIES(polhode_rigid_body_kernel_, std::string_view, const polhode::rigid_body&,
                        std::span<const double>, double, std::unique_ptr<polhode::kernel>&);
