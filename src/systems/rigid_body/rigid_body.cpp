#include "systems/rigid_body/rigid_body.hpp"

#include "platform/isa_entry.hpp"
#include "systems/systems.hpp"

namespace polhode {

std::vector<parameter_rule> rigid_body_parameters() {
  auto damping = number_from_zero("theta", "time / inertia", "dissipation: dh/dt = -theta |Pi x Omega|^2");
  damping.role = role::dissipation;
  return {positive_vector_of("inertia", 3, "inertia", "principal moments of inertia"), damping,
          noise_vectors(3, "1 / time^(1/2)")};
}

subject bind_rigid_body(const report::scene& scene) {
  subject out;
  by_isa(POLHODE_ENTRIES(polhode_bind_rigid_body_))(scene, out);
  return out;
}

}  // namespace polhode
