// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: the rigid body's face that is bound to a step size and an orbit.
#include "systems/rigid_body/rigid_body_entries.hpp"
#include "systems/rigid_body/rigid_body_face.hpp"

namespace polhode {
namespace {

/// For states of length radius.
std::shared_ptr<const face> bound_face_of(const rigid_body& body, double radius, double dt) {
  const auto made = [&]<rotation_size size>() -> std::shared_ptr<const face> {
    if (parts_of(body).last_turn) return std::make_shared<bound_body<size, false>>(body, dt, radius);
    return std::make_shared<bound_body<size, true>>(body, dt, radius);
  };
  switch (rotation_size_of(body, radius, dt)) {
    case rotation_size::tiny:
      if (parts_of(body).dissipation) return made.template operator()<rotation_size::tiny>();
      [[fallthrough]];
    case rotation_size::small: return made.template operator()<rotation_size::small>();
    case rotation_size::moderate: return made.template operator()<rotation_size::moderate>();
    default: return made.template operator()<rotation_size::any>();
  }
}

}  // namespace
}  // namespace polhode

extern "C" void POLHODE_ENTRY(polhode_rigid_body_face_)(const polhode::rigid_body& body, double radius, double dt,
                                                        std::shared_ptr<const polhode::face>& out) {
  out = polhode::bound_face_of(body, radius, dt);
}
