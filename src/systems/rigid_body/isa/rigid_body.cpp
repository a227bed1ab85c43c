// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: the rigid body meets its schemes. The costliest kernels are in sources of their
// own, so that several processors compile them.
#include "systems/rigid_body/rigid_body.hpp"

#include "platform/isa_entry.hpp"
#include "systems/rigid_body/rigid_body_kernels.hpp"
#include "systems/rigid_body/rigid_body_parties.hpp"
#include "systems/schemes.hpp"

namespace polhode {

#define POLHODE_ELSEWHERE(scheme) extern POLHODE_MEETS_RIGID_BODY(scheme)
POLHODE_SPLITTINGS(POLHODE_ELSEWHERE)
POLHODE_ROTATIONS(POLHODE_ELSEWHERE)

}  // namespace polhode

extern "C" void POLHODE_ENTRY(polhode_bind_rigid_body_)(const polhode::report::scene& scene, polhode::subject& out) {
  out = polhode::bind(scene, polhode::make_rigid_body, polhode::all_schemes{});
}
