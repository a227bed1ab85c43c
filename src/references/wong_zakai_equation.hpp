// SPDX-License-Identifier: Apache-2.0
// The Wong-Zakai equation, which is driven by a piecewise linear path: on a segment with increments dW over dt,
//
//   dmu/ds = ad*_{xi(mu)} mu,   xi(mu) = a(mu) dt + sum sigma_i dW^i,   s from 0 to 1,
//
// by the fourth-order Munthe-Kaas method, classical tableau. With mu = Ad*_exp(u) mu_0 and C(xi) = ad*_xi an
// anti-homomorphism (lie/so3.hpp), u' = dexp_inv(-u, xi) = xi + [u, xi] / 2 + …; of all its brackets two are left where
// those that are of fifth order in the stages, or cancel among them, are dropped. Source: Munthe-Kaas, Appl. Numer.
// Math. 29 (1999) 115-127; the brackets: Munthe-Kaas, Owren, Phil. Trans. R. Soc. A 357 (1999) 957-981.
//
// Written as a scheme, so that the same kernels run it; it is no scheme of the list, as it is the reference.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct wong_zakai_equation {
  static constexpr scheme_info info{.name = "wong_zakai_equation",
                                    .title = "Wong-Zakai equation, fourth order",
                                    .source = "Munthe-Kaas 1999",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 4,
                                    .casimir = keeps_casimirs};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto slope = [&](const vec<S, System::dimension>& u) { return generator(system, g::exp_action(u, mu), w); };
    const auto k1 = generator(system, mu, w);
    const auto k2 = slope(S(0.5) * k1);
    const auto k3 = slope(S(0.5) * k2 + S(0.125) * g::bracket(k1, k2));
    const auto k4 = slope(k3);
    return g::exp_action(S(1.0 / 6) * (k1 + S(2.0) * (k2 + k3) + k4 + S(0.5) * g::bracket(k1, k4)), mu);
  }
};

}  // namespace polhode
