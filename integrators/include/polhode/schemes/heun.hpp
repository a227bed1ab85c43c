// SPDX-License-Identifier: Apache-2.0
// Stochastic Heun: predictor and trapezoidal corrector, drift and noise alike.
//
//   dmu = ad*_xi mu,   xi(mu) = a(mu) dt + sigma o dW                                                    (Stratonovich)
//   mu* = mu_n + ad*_{xi(mu_n)} mu_n,   mu_{n+1} = mu_n + 1/2 ad*_{xi(mu_n)} mu_n + 1/2 ad*_{xi(mu*)} mu*
//
// Source: Ruemelin, SIAM J. Numer. Anal. 19 (1982) 604-613, the Heun case of its Runge-Kutta family.
// Leaves the orbit. Cost a step: two generators, two coadjoint operators, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct heun {
  static constexpr scheme_info info{.name = "heun",
                                    .title = "Stochastic Heun",
                                    .source = "Ruemelin 1982",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = casimirs_drift(1, 3)};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto first = motion(system, mu, w);
    return mu + S(0.5) * (first + motion(system, mu + first, w));
  }
};

}  // namespace polhode
