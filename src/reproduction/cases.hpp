// SPDX-License-Identifier: Apache-2.0
// The cases, one source each. Each says who published what, and where.
#pragma once

#include "reproduction/reproduce.hpp"

namespace polhode {

report::reproduction uniaxial_spin(const reproduce_options&);
report::reproduction two_spins(const reproduce_options&);
report::reproduction magpy_convergence(const reproduce_options&);
report::reproduction sds_on_s2(const reproduce_options&);
report::reproduction lie_poisson_midpoint(const reproduce_options&);
report::reproduction attractor_of_the_paper(const reproduce_options&);

}  // namespace polhode
