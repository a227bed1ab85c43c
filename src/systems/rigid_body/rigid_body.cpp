#include "systems/rigid_body/rigid_body.hpp"

#include "platform/isa_entry.hpp"
#include "systems/systems.hpp"

namespace polhode {

subject bind_rigid_body(const report::scene& scene) {
  subject out;
  by_isa(POLHODE_ENTRIES(polhode_bind_rigid_body_))(scene, out);
  return out;
}

}  // namespace polhode
