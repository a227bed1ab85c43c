// SPDX-License-Identifier: Apache-2.0
// Two spins, in registers: their faces. What they offer is in spins.cpp.
#include <polhode/systems/spins.hpp>

#include <algorithm>
#include <memory>
#include <vector>

#include "systems/spins/spins_of.hpp"
#include "systems/system_source.hpp"

#if defined(POLHODE_ISA)
#include "ensemble/faces/face_with_flows.hpp"
#include "systems/spins/spin_pair_at.hpp"
#endif

namespace polhode {
namespace {

[[maybe_unused]] spin_pair make_spin_pair(const report::scene& s) {
  std::vector<spin_pair::column> vectors;
  for (const auto& v : noise_vectors_of(s)) std::ranges::copy(v, vectors.emplace_back().c.begin());
  return spins_of<spin_pair>(s, spin_pair::from_vectors(vectors));
}

}  // namespace

#if defined(POLHODE_ISA)
template <>
struct faces_for<spin_pair> : kernels_beside<milstein> {
  static std::shared_ptr<const face> values(const spin_pair& system, std::span<const double> momentum, double dt) {
    return bound_where_it_fits<spin_pair, spin_pair_at>(system, momentum, dt);
  }
};
#endif

}  // namespace polhode

POLHODE_BEHIND_FACES(spin_pair, polhode::make_spin_pair);
