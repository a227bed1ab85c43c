// SPDX-License-Identifier: Apache-2.0
// Two spins, in registers: their meeting with the schemes. What they offer is in spins.cpp.
#include <polhode/systems/spins.hpp>

#include <algorithm>
#include <memory>
#include <vector>

#include "systems/spins/spins_of.hpp"
#include "systems/system_source.hpp"

#if defined(POLHODE_ISA)
#include "systems/kernels_in_registers.hpp"
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
template <class Scheme>
std::unique_ptr<kernel> kernel_for(scheme_tag<Scheme>, const spin_pair& system, const std::vector<double>& momentum,
                                   double dt) {
  return kernel_in_registers<Scheme, spin_pair_at>(system, momentum, dt);
}
#endif

}  // namespace polhode

POLHODE_MEETS_SCHEMES(spin_pair, polhode::make_spin_pair);
