// SPDX-License-Identifier: Apache-2.0
// Lie-Trotter splitting: free rotation, dissipation, noise, one after the other.
//
//   mu_{n+1} = N(dW) D(dt) F(dt) mu_n                                                                    (Stratonovich)
//   F free motion, D dissipation, N(dW) = Ad*_exp(sigma dW): the exact flow of each part (F to second order)
//
// Source: Trotter, Proc. AMS 10 (1959) 545-551; Brehier, Cohen, Jahnke, Math. Comp. 92 (2023) (stochastic Lie-Poisson).
// Keeps every Casimir: each part is a coadjoint motion. Cost a step: three flows, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct lie_trotter {
  static constexpr scheme_info info{.name = "lie_trotter",
                                    .title = "Lie-Trotter splitting",
                                    .source = "Trotter 1959; Brehier, Cohen, Jahnke 2023",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 1,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential,
                                    .poisson = true};

  template <splittable_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const whole_step whole{w.dt};
    return noise_flow(system, system.dissipation_flow(system.free_flow(mu, whole), whole), w);
  }
};

}  // namespace polhode
