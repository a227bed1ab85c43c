// Strang splitting with noise of weak order two: Strang on a system whose noise vectors are changed once, by O(dt).
//
//   mu_{n+1} = D(dt/2) F(dt/2) Ad*_exp(T(dt) dW) F(dt/2) D(dt/2) mu_n,   T T^T dt = Q dt + R dt^2 (Stratonovich)
//
// Q and R: systems/constant_noise.hpp, weak_order_two. Isotropic noise on so(3): T = sigma sqrt(1 - sigma^2 dt/12).
//
// Source: Strang 1968; the noise step is derived where it stands. Keeps every Casimir. Cost a step: Strang's.
#pragma once

#include <polhode/schemes/strang.hpp>

namespace polhode {

struct strang_weak2 {
  static constexpr scheme_info info{.name = "strang_weak2",
                                    .title = "Strang splitting, noise of weak order 2",
                                    .source = "Strang 1968; noise covariance: constant_noise::weak_order_two",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 2, .isotropic = 2, .general = 2},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs};

  template <splittable_system System>
  static System prepare(const System& system, double dt) {
    return system.with_noise(system.weak_order_two(dt));
  }

  template <splittable_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return strang::step(system, mu, w);
  }
};

}  // namespace polhode
