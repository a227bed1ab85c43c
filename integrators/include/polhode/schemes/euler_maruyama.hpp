// SPDX-License-Identifier: Apache-2.0
// Euler-Maruyama: the explicit Euler step of the Ito equation.
//
//   dmu = ad*_{a(mu)} mu dt + 1/2 sum_i ad*_{sigma_i} ad*_{sigma_i} mu dt + sum_i ad*_{sigma_i} mu dW^i          (Ito)
//   mu_{n+1} = mu_n + ad*_xi mu_n + 1/2 sum_i ad*_{sigma_i} ad*_{sigma_i} mu_n dt,   xi = a(mu_n) dt + sum sigma_i dW^i
//
// Source: Maruyama, Rend. Circ. Mat. Palermo 4 (1955) 48-90; Kloeden, Platen (1992), eq. (10.2.4).
// Leaves the orbit: |mu|^2 is kept in the mean alone. Cost a step: one generator, one Ito drift, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct euler_maruyama {
  static constexpr scheme_info info{.name = "euler_maruyama",
                                    .title = "Euler-Maruyama, Ito",
                                    .source = "Maruyama 1955; Kloeden, Platen 1992, eq. (10.2.4)",
                                    .calculus = calculus::ito,
                                    .strong_order = {.commuting = 0.5, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 1,
                                    .casimir = casimirs_drift(0.5, 1)};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return mu + motion(system, mu, w) + S(w.dt) * system.ito_drift(mu);
  }
};

}  // namespace polhode
