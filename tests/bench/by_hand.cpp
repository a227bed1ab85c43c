// SPDX-License-Identifier: Apache-2.0
#include "bench/yardsticks.hpp"

#include <memory>

#include "bench/by_hand.hpp"
#include "platform/isa.hpp"

namespace polhode::bench {

loop peak_loop(isa level) {
  constexpr long rounds = 20'000;
  choose_isa(level);
  const auto chains = by_isa(POLHODE_ENTRIES(polhode_bench_fma_chains_));
  return {chains(1) * rounds, [chains] { chains(rounds); }, "flop"};
}

std::vector<double> heun_by_hand(isa level, const report::scene& scene, int steps, double dt) {
  choose_isa(level);
  const auto& inertia = scene.vector("inertia");
  const double a = 1 / inertia[0], b = 1 / inertia[1], c = 1 / inertia[2], theta = scene.number("theta");
  const heun_constants constants{dt * (a - b), theta * dt * (a - c), dt * (c - b), theta};
  std::vector<double> states;
  for (const double x : scene.momentum) states.insert(states.end(), paths_by_hand, x);
  by_isa(POLHODE_ENTRIES(polhode_bench_heun_))(states.data(), paths_by_hand, steps, &constants);
  return states;
}

loop by_hand_loop(isa level, const report::scene& scene, int steps, double dt) {
  return {static_cast<double>(steps) * paths_by_hand, [=] { heun_by_hand(level, scene, steps, dt); }};
}

}  // namespace polhode::bench
