// Defects that only the step itself can have: a parametrised one per kind, on the kernel of any system, not on that
// which the rigid body ships.
#pragma once

#include "mutants/defect.hpp"

namespace polhode::test {

/// The defective step in the place of the scheme's own. Throws std::invalid_argument on a kind that is none of these.
scheme_entry defective_step(const report::scene&, const scheme_entry& healthy, const defect&);

}  // namespace polhode::test
