// SPDX-License-Identifier: Apache-2.0
// Defects that only the step itself can have: a parametrised one per kind, on the forms of the rigid body that ship.
#pragma once

#include "mutants/defect.hpp"

namespace polhode::test {

/// The kernel of the defective step in the place of the scheme's own. Throws std::invalid_argument on a kind that is
/// none of these, and on another scheme than the defect's.
std::unique_ptr<kernel> defective_step(const report::scene&, std::string_view scheme, const defect&, double dt);

}  // namespace polhode::test
