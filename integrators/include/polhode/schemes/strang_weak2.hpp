// SPDX-License-Identifier: Apache-2.0
// Strang splitting with noise of weak order two: the noise vectors are changed once, by O(dt).
//
//   mu_{n+1} = D(dt/2) F(dt/2) Ad*_exp(T(dt) dW) F(dt/2) D(dt/2) mu_n,   T T^T dt = Q dt + R dt^2 (Stratonovich)
//   F free motion (itself a palindrome of turns), D dissipation
//
// Q and R: systems/constant_noise.hpp, weak_order_two. Isotropic noise on so(3): T = sigma sqrt(1 - sigma^2 dt/12).
//
// Source: Strang, SIAM J. Numer. Anal. 5 (1968) 506-517; the noise step is derived where it stands. Keeps every
// Casimir. Cost a step: five flows, the dissipation merged with the next step's; one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct strang_weak2 {
  static constexpr scheme_info info{.name = "strang_weak2",
                                    .title = "Strang splitting, noise of weak order 2",
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

  /// Two of `outer` in a row are one of the sum of their times.
  template <class System>
  static constexpr bool merges = exact_dissipation<System>;

  template <splittable_system System, class S, class Time>
  static auto outer(const System& system, const vec<S, System::dimension>& mu, Time t) {
    return system.dissipation_flow(mu, t);
  }

  template <splittable_system System, class S>
  static auto inner(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const half_step half{w.dt};
    return system.free_flow(noise_flow(system, system.free_flow(mu, half), w), half);
  }

  template <splittable_system System, class S>
  requires constant_noise_system<System>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const half_step half{w.dt};
    return outer(system, inner(system, outer(system, mu, half), w), half);
  }
};

}  // namespace polhode
