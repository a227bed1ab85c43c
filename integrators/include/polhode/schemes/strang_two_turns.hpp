// SPDX-License-Identifier: Apache-2.0
// strang with noise of weak order two: the noise vectors are changed once, by O(dt).
//
//   mu_{n+1} = T1(dt/2) T2(dt/2) D(dt/2) N(T(dt) dW) D(dt/2) T2(dt/2) T1(dt/2) mu_n (Stratonovich) T(dt) T(dt)^T dt = Q
//   dt + R dt^2,   turns T1, T2, dissipation D and noise N as in strang.hpp
//
// A palindrome of flows, each of weak order two at least, is of weak order two. Q and R: systems/constant_noise.hpp,
// weak_order_two. Isotropic noise on so(3): T = sigma sqrt(1 - sigma^2 dt/12). strang_weak2 has the same noise in the
// palindrome of five turns (of a spin's three), which takes more of them and errs by more.
//
// Source: Strang, SIAM J. Numer. Anal. 5 (1968) 506-517; the noise step is derived where it stands. Keeps every
// Casimir. Cost a step: strang's.
#pragma once

#include <polhode/schemes/scheme_info.hpp>
#include <polhode/schemes/strang.hpp>

namespace polhode {

struct strang_two_turns : strang {
  static constexpr scheme_info info{.name = "strang_two_turns",
                                    .title = "Strang splitting in two turns, noise of weak order 2",
                                    .source = "Strang 1968; noise covariance: constant_noise::weak_order_two",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 2, .isotropic = 2, .general = 2},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::exponential,
                                    .poisson = true};

  template <constant_noise_system System>
  static System prepare(const System& system, double dt) {
    return system.with_noise(system.weak_order_two(dt));
  }

  template <turning_system System, class S>
  requires constant_noise_system<System>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return strang::step(system, mu, w);
  }
};

}  // namespace polhode
