// SPDX-License-Identifier: Apache-2.0
// Strang splitting in the palindrome that takes the fewest rotations.
//
//   mu_{n+1} = T1(dt/2) T2(dt/2) D(dt/2) N(dW) D(dt/2) T2(dt/2) T1(dt/2) mu_n                            (Stratonovich)
//   T1, T2 turns that make up the free motion, D dissipation, N(dW) = Ad*_exp(sigma dW)
//
// h and h plus a Casimir have the same motion, and a suitable multiple leaves two parts with exact flows (so(3): h -
// |mu|^2 / 2 I_2 = 1/2 (1/I_1 - 1/I_2) mu_1^2 + 1/2 (1/I_3 - 1/I_2) mu_3^2). The last turn of a step and the first of
// the next are one: whoever runs many steps may merge them.
//
// Weak order 2 only where one exponential of sigma dW has the law of the noise, that is for one vector; else 1, because
// of the noise alone (see strang_weak2).
//
// Source: Strang, SIAM J. Numer. Anal. 5 (1968) 506-517; Brehier, Cohen, Jahnke, Math. Comp. 92 (2023) (stochastic
// Lie-Poisson). Keeps every Casimir: each part is a coadjoint motion. Cost a step: seven flows, six where
// steps follow each other; one increment.
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
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential,
                                    .poisson = true};

  /// Two of `outer` in a row are one of the sum of their times.
  template <class System>
  static constexpr bool merges = true;

  template <turning_system System, class S, class Time>
  static auto outer(const System& system, const vec<S, System::dimension>& mu, Time t) {
    return system.first_turn(mu, t);
  }

  template <turning_system System, class S>
  static auto inner(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return turned_noise_flow(system, mu, w);
  }

  template <turning_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const half_step half{w.dt};
    return outer(system, inner(system, outer(system, mu, half), w), half);
  }
};

}  // namespace polhode
