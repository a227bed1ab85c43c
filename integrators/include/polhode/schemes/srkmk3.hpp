// SPDX-License-Identifier: Apache-2.0
// Three-stage stochastic Munthe-Kaas: Kutta's method of third order in the Lie algebra, driven by the step's increment.
//
//   xi(mu) = a(mu) dt + sum sigma_i dW^i,   k_j = dexp^-1(-u_j, xi(Ad*_exp(u_j) mu_n)),   u_1 = 0, u_2 = k_1/2,
//   u_3 = 2 k_2 - k_1,   mu_{n+1} = Ad*_exp((k_1 + 4 k_2 + k_3)/6) mu_n                                  (Stratonovich)
//
// Sign of u_j: C(xi) = ad*_xi is an anti-homomorphism (lie/so3.hpp). Third order without noise; what limits it with
// noise is that it sees the increment alone.
//
// Source: Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115-127; Muniz, Ehrhardt, Guenther, Winkler, Appl. Numer. Math. 193
// (2023) 196-203 (stochastic). Keeps every Casimir. Cost a step: three generators, three actions, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct srkmk3 {
  static constexpr scheme_info info{.name = "srkmk3",
                                    .title = "Stochastic Munthe-Kaas, three stages",
                                    .source = "Munthe-Kaas 1999; Muniz, Ehrhardt, Guenther, Winkler 2023",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 3,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto stage = [&](const vec<S, System::dimension>& u) {
      return g::dexp_inv(-u, generator(system, g::exp_action(u, mu), w));
    };
    const auto k1 = generator(system, mu, w);
    const auto k2 = stage(S(0.5) * k1);
    const auto k3 = stage(S(2.0) * k2 - k1);
    return g::exp_action(S(1.0 / 6) * (k1 + S(4.0) * k2 + k3), mu);
  }
};

}  // namespace polhode
