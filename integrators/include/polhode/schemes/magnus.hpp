// SPDX-License-Identifier: Apache-2.0
// Magnus with Levy areas: the first two terms of the Magnus series of the noise, Heun's average of the drift.
//
//   dmu = ad*_xi mu,   xi = a(mu) dt + sum sigma_i o dW^i                                                (Stratonovich)
//   B = sum sigma_i dW^i,   L = sum_{i<j} A^ij [sigma_i, sigma_j]    (constant sigma_i; else area_noise,
//   lie_poisson.hpp) mu* = Ad*_exp(a(mu_n) dt + B) mu_n,   mu_{n+1} = Ad*_exp(1/2 (a(mu_n) + a(mu*)) dt + B + L) mu_n
//
// Sign of the area: A^ij = 1/2 (int W^i dW^j - int W^j dW^i), and exp(ad*_{B+L}) = 1 + ad*_B + sum_ij J^ij
// ad*_{sigma_j} ad*_{sigma_i} + …, J^ij = int W^i o dW^j. A wrong sign leaves every invariant intact and order 1/2:
// only the slope tells.
//
// Source: Castell, Gaines, Ann. IHP Probab. Stat. 32 (1996) 231-250; Malham, Wiese 2008 (on Lie groups).
// Keeps every Casimir. Cost a step: two generators, two actions, one increment with areas.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct magnus {
  static constexpr scheme_info info{.name = "magnus",
                                    .title = "Magnus with Levy areas",
                                    .source = "Castell, Gaines 1996; Malham, Wiese 2008",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 1},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential};

  template <bracketed_noise_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu,
                   const wiener_levy<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto first = generator(system, mu, w);
    const auto second = generator(system, g::exp_action(first, mu), w);
    return g::exp_action(S(0.5) * (first + second) + area_noise(system, mu, w), mu);
  }
};

}  // namespace polhode
