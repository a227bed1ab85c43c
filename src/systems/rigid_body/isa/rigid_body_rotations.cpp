// SPDX-License-Identifier: Apache-2.0
#include "systems/rigid_body/rigid_body_kernels.hpp"
#include "systems/rigid_body/rigid_body_parties.hpp"
#include "systems/schemes.hpp"

namespace polhode {

POLHODE_ROTATIONS(POLHODE_MEETS_RIGID_BODY)

}  // namespace polhode
