// Strang splitting: the same three flows in a palindrome.
//
//   mu_{n+1} = D(dt/2) F(dt/2) N(dW) F(dt/2) D(dt/2) mu_n                                                (Stratonovich)
//   F free motion, D dissipation, N(dW) = Ad*_exp(sigma dW)
//
// Weak order 2 only where one exponential of sigma dW has the law of the noise, that is for one vector; else 1, because
// of the noise alone (see strang_weak2).
//
// Source: Strang, SIAM J. Numer. Anal. 5 (1968) 506-517; Brehier, Cohen, Jahnke, Math. Comp. 92 (2023) (stochastic
// Lie-Poisson). Keeps every Casimir: each part is a coadjoint motion. Cost a step: five flows, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct strang {
  static constexpr scheme_info info{.name = "strang",
                                    .title = "Strang splitting",
                                    .source = "Strang 1968; Brehier, Cohen, Jahnke 2023",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 2, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs};

  template <splittable_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const double half = w.dt / 2;
    const auto before = system.free_flow(system.dissipation_flow(mu, half), half);
    const auto after = System::algebra::exp_action(system.noise(w.dw), before);
    return system.dissipation_flow(system.free_flow(after, half), half);
  }
};

}  // namespace polhode
