// SPDX-License-Identifier: Apache-2.0
// Lie-Euler: one coadjoint action along the generator frozen at the start.
//
//   dmu = ad*_xi mu,   xi = a(mu) dt + sigma o dW                                                        (Stratonovich)
//   mu_{n+1} = Ad*_exp(xi_n) mu_n,   xi_n = a(mu_n) dt + sigma dW
//
// The exponential of the noise contains its Ito correction. Source: Malham, Wiese, SIAM J. Sci. Comput. 30 (2008)
// 597-617. Keeps every Casimir: a coadjoint action. Cost a step: one generator, one action, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct lie_euler {
  static constexpr scheme_info info{.name = "lie_euler",
                                    .title = "Lie-Euler, exponential",
                                    .source = "Malham, Wiese 2008",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 1,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential};

  template <constant_noise_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return System::algebra::exp_action(generator(system, mu, w), mu);
  }
};

}  // namespace polhode
