// Compiled once per instruction set: the rigid body meets its schemes.
#include "registry/rigid_body.hpp"

#include "ensemble/isa_entry.hpp"
#include "registry/rigid_body_kernels.hpp"
#include "registry/schemes.hpp"

extern "C" void POLHODE_ENTRY(polhode_bind_rigid_body_)(const polhode::report::scene& scene, polhode::subject& out) {
  out = polhode::bind(scene, polhode::make_rigid_body, polhode::all_schemes{});
}
