// SPDX-License-Identifier: Apache-2.0
#include "systems/systems.hpp"

#include <algorithm>
#include <memory>

namespace polhode {

/// All of them: name_system() is in systems/name.cpp or systems/name/.
#define POLHODE_SYSTEMS(apply)                                                                                     \
  apply(rigid_body) apply(spin) apply(so4_body) apply(heavy_top) apply(spins) apply(maxwell_bloch) apply(son_body) \
      apply(vortices) apply(sine_euler)

#define POLHODE_DECLARED(name) system_entry name##_system();
POLHODE_SYSTEMS(POLHODE_DECLARED)

const std::vector<system_entry>& systems() {
#define POLHODE_LISTED(name) name##_system(),
  static const std::vector<system_entry> all{POLHODE_SYSTEMS(POLHODE_LISTED)};
  return all;
}

parameter_rule momentum_rule(const system_entry& of) {
  return of.momentum ? *of.momentum
                     : nonzero_vector_of("momentum", of.dimension, std::string(of.unit), "initial momentum");
}

const system_entry* find_system(std::string_view name) {
  const auto found = std::ranges::find(systems(), name, &system_entry::name);
  return found == systems().end() ? nullptr : &*found;
}

std::shared_ptr<const capabilities> offers_of(const report::scene& s) {
  const auto* system = find_system(s.system);
  const bool fits = system != nullptr && (system->dimension == 0 || s.momentum.size() == system->dimension);
  return std::make_shared<const capabilities>(fits ? system->offers(s) : capabilities{});
}

}  // namespace polhode
