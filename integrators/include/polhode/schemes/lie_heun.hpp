// SPDX-License-Identifier: Apache-2.0
// Lie-Heun: Heun's predictor-corrector in the Lie algebra; one coadjoint action per stage.
//
//   dmu = ad*_xi mu,   xi = a(mu) dt + sigma o dW                                                        (Stratonovich)
//   xi_1 = a(mu_n) dt + sigma dW,   mu* = Ad*_exp(xi_1) mu_n
//   xi_2 = a(mu*) dt + sigma dW,    mu_{n+1} = Ad*_exp(1/2 xi_1 + 1/2 xi_2) mu_n
//
// Source: Munthe-Kaas, BIT 38 (1998) 92-111 (RKMK2); Malham, Wiese 2008 (stochastic).
// Keeps every Casimir: a coadjoint action. Cost a step: two generators, two actions, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct lie_heun {
  static constexpr scheme_info info{.name = "lie_heun",
                                    .title = "Lie-Heun, two-stage Munthe-Kaas",
                                    .source = "Munthe-Kaas 1998; Malham, Wiese 2008",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto first = generator(system, mu, w);
    const auto second = generator(system, g::exp_action(first, mu), w);
    return g::exp_action(S(0.5) * (first + second), mu);
  }
};

}  // namespace polhode
