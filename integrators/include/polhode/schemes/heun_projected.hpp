// SPDX-License-Identifier: Apache-2.0
// Stochastic Heun, then the nearest point of the orbit through mu_n.
//
//   mu_{n+1} = P(Heun(mu_n)),   P: nearest point with the Casimirs of mu_n
//
// Source: Ruemelin 1982 (Heun); Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), algorithm IV.4.2
// (projection). Keeps the Casimirs to rounding, not by geometry but by force. Cost a step: Heun's and one projection.
#pragma once

#include <polhode/schemes/heun.hpp>

namespace polhode {

struct heun_projected {
  static constexpr scheme_info info{.name = "heun_projected",
                                    .title = "Stochastic Heun with projection",
                                    .source = "Ruemelin 1982; Hairer, Lubich, Wanner 2006, algorithm IV.4.2",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return System::algebra::orbit_projection(heun::step(system, mu, w), mu);
  }
};

}  // namespace polhode
