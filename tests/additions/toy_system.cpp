// SPDX-License-Identifier: Apache-2.0
// The quartic top: its table, what it offers, and its faces.
#include <polhode/systems/toy_system.hpp>

#include <cmath>
#include <vector>

#include "problem/vectors.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

[[maybe_unused]] toy_system make_toy_system(const report::scene& s) {
  std::vector<toy_system::column> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back({{v[0], v[1], v[2]}});
  return {s.number("stiffness"), dissipation_of(s), toy_system::from_vectors(vectors)};
}

}  // namespace
}  // namespace polhode

POLHODE_BEHIND_FACES(toy_system, polhode::make_toy_system);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

capabilities toy_system_offers(const report::scene& s) {
  const double c = length(s.momentum), turn = std::fabs(s.number("stiffness")) * c * c * c;
  capabilities out;
  out.rates = {.motion = turn, .dissipation = dissipation_of(s) * c * turn, .damping = c * turn, .noise = 0};
  for (const auto& v : noise_vectors_of(s)) out.rates.noise += std::pow(length(v), 2);
  return out;
}

}  // namespace

system_entry toy_system_system();

system_entry toy_system_system() {
  return {.name = "toy_system",
          .title = "A quartic top on so(3)*",
          .dimension = 3,
          .unit = "momentum",
          .parameters = {number_of("stiffness", "1 / (momentum^3 time)", "k in h = k Pi_3^4 / 4"),
                         dissipation_strength("1 / momentum", "dissipation"), noise_vectors(3, "1 / time^(1/2)")},
          .observables = {{"energy", "h"}},
          .bind = POLHODE_BOUND_TO_SCHEMES(toy_system),
          .offers = toy_system_offers};
}

}  // namespace polhode
#endif
