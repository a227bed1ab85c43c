// SPDX-License-Identifier: Apache-2.0
// The kernels of an integrator from elsewhere.
#pragma once

#include <memory>

#include "ensemble/kernel.hpp"
#include "ensemble/tangent_kernel.hpp"
#include "foreign/foreign_scheme.hpp"

namespace polhode::foreign {

std::unique_ptr<kernel> make_kernel(std::shared_ptr<foreign_scheme>, const problem&);

/// Tangents by central differences of sixth order of the integrator's own steps: good to about thirteen digits where a
/// step is smooth over 2^-7 of |mu|.
std::unique_ptr<tangent_kernel> make_tangent_kernel(std::shared_ptr<foreign_scheme>, const problem&);

}  // namespace polhode::foreign
