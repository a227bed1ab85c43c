// SPDX-License-Identifier: Apache-2.0
// Milstein with Levy areas.
//
//   dmu = ad*_xi mu,   xi = a(mu) dt + sum sigma_i o dW^i                                                (Stratonovich)
//   B = sum sigma_i dW^i,   L = sum_{i<j} A^ij [sigma_i, sigma_j]
//   mu_{n+1} = mu_n + ad*_{a dt + B + L} mu_n + 1/2 ad*_B ad*_B mu_n
// for constant sigma_i; else L and the last term have derivatives of sigma_i besides (area_noise, noise_twice,
// lie_poisson.hpp).
//
// Sign of the area: A^ij = 1/2 (int W^i dW^j - int W^j dW^i), and sum_ij A^ij ad*_{sigma_j} ad*_{sigma_i} = ad*_L.
// Source: Milstein 1974; Kloeden, Platen (1992), eq. (10.3.4), the Stratonovich form for general noise.
// Leaves the orbit. Cost a step: one generator, three coadjoint operators, one increment with areas.
#pragma once

#include <polhode/schemes/milstein_no_area.hpp>

namespace polhode {

struct milstein {
  static constexpr scheme_info info{.name = "milstein",
                                    .title = "Milstein with Levy areas",
                                    .source = "Milstein 1974; Kloeden, Platen 1992, eq. (10.3.4)",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 1},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 1,
                                    .casimir = casimirs_drift(1, 1)};

  template <bracketed_noise_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu,
                   const wiener_levy<S, System::channels>& w) {
    return milstein_no_area::step(system, mu, w) + System::algebra::coad(area_noise(system, mu, w), mu);
  }
};

}  // namespace polhode
