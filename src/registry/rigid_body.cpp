// The rigid body meets its schemes.
#include <polhode/systems/rigid_body.hpp>

#include "registry/bind.hpp"
#include "registry/schemes.hpp"
#include "registry/systems.hpp"

namespace polhode {

rigid_body make_rigid_body(const report::scene& s) {
  std::vector<rigid_body::column> vectors;
  for (const auto& v : s.sigma) vectors.push_back({v});
  return rigid_body(s.inertia, s.theta, rigid_body::from_vectors(vectors));
}

subject bind_rigid_body(const report::scene& scene) { return bind(scene, make_rigid_body, all_schemes{}); }

}  // namespace polhode
