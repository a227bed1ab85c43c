// SPDX-License-Identifier: Apache-2.0
// Milstein without Levy areas: the symmetric part of the double integrals alone.
//
//   B = sum sigma_i dW^i,   mu_{n+1} = mu_n + ad*_{a dt + B} mu_n + 1/2 ad*_B ad*_B mu_n (Stratonovich)
//
// Source: Milstein 1974; Kloeden, Platen (1992), eq. (10.3.4) with J_(i,j) = 1/2 dW^i dW^j: exact for commuting noise,
// order 1/2 for any other (Clark, Cameron 1980).
// Leaves the orbit. Cost a step: one generator, two coadjoint operators, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct milstein_no_area {
  static constexpr scheme_info info{.name = "milstein_no_area",
                                    .title = "Milstein without areas",
                                    .source = "Milstein 1974; Kloeden, Platen 1992, eq. (10.3.4) without areas",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 1,
                                    .casimir = casimirs_drift(1, 1)};

  template <bracketed_noise_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return mu + motion(system, mu, w) + S(0.5) * noise_twice(system, mu, w);
  }
};

}  // namespace polhode
