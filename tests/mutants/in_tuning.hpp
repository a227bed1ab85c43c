// SPDX-License-Identifier: Apache-2.0
// Defects that only a kernel tuned to the rigid body can have: in what is computed once for a step size, and in the
// choice of the kernel. The scheme is the healthy one.
#pragma once

#include "mutants/defect.hpp"

namespace polhode::test {

/// Throws std::invalid_argument on a kind that is none of these, and on a scheme for which none is compiled.
std::unique_ptr<kernel> defective_tuning(const report::scene&, std::string_view scheme, const defect&, double dt);

}  // namespace polhode::test
