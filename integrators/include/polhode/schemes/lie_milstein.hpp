// SPDX-License-Identifier: Apache-2.0
// Geometric Milstein: one exponential of Milstein's terms.
//
//   B = sum sigma_i dW^i,   L = sum_{i<j} A^ij [sigma_i, sigma_j],   mu_{n+1} = Ad*_exp(a(mu_n) dt + B + L + D) mu_n
//
// D = 1/2 DB[ad*_B mu_n] where sigma_i depend on the state, when L has derivatives as well (area_noise,
// lie_poisson.hpp). The exponential contains 1/2 ad*_B ad*_B: strong order 1 for noise that does not commute, at one
// action.
//
// Source: Castell, Gaines, Ann. IHP Probab. Stat. 32 (1996) 231-250 (the exponent); Wang, Solo, arXiv:2605.04480
// (strong order 1 on SO(n) and SE(n)). Keeps every Casimir. Cost a step: one generator, one action, one increment with
// areas.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct lie_milstein {
  static constexpr scheme_info info{.name = "lie_milstein",
                                    .title = "Geometric Milstein with Levy areas",
                                    .source = "Castell, Gaines 1996; Wang, Solo 2026",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 1},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 1,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential};

  template <bracketed_noise_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu,
                   const wiener_levy<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto xi = generator(system, mu, w) + area_noise(system, mu, w);
    if constexpr (constant_noise_system<System>) {
      return g::exp_action(xi, mu);
    } else {
      const auto moved = g::coad(noise(system, mu, w), mu);
      return g::exp_action(xi + S(0.5) * system.noise_slope_at(mu, w, moved), mu);
    }
  }
};

}  // namespace polhode
