// SPDX-License-Identifier: Apache-2.0
// A healthy kernel whose time, increments or states are spoilt on the way.
#pragma once

#include <memory>

#include "mutants/defect.hpp"

namespace polhode::test {

/// The kernel of a step dt of the scene, with a defect of time, of the increments or of the state after a step.
std::unique_ptr<kernel> defective(const scheme_entry&, const report::scene&, const defect&, double dt);

}  // namespace polhode::test
