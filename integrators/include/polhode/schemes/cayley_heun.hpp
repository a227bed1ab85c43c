// SPDX-License-Identifier: Apache-2.0
// Cayley-Heun: Lie-Heun with the Cayley map in place of the exponential; no transcendental function.
//
//   xi_1 = a(mu_n) dt + sigma dW,   mu* = Cay(xi_1) mu_n                                                 (Stratonovich)
//   xi_2 = a(mu*) dt + sigma dW,    mu_{n+1} = Cay(1/2 xi_1 + 1/2 xi_2) mu_n
//
// Source: Iserles, Found. Comput. Math. 1 (2001) 129-160 (Cayley-transform methods); noise as in Malham, Wiese 2008.
// Keeps every quadratic Casimir: a coadjoint action. Cost a step: two generators, two actions, one increment.
#pragma once

#include <polhode/schemes/scheme_info.hpp>

namespace polhode {

struct cayley_heun {
  static constexpr scheme_info info{.name = "cayley_heun",
                                    .title = "Cayley-Heun",
                                    .source = "Iserles 2001; Malham, Wiese 2008",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::cayley};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto first = generator(system, mu, w);
    const auto second = generator(system, g::cayley_action(first, mu), w);
    return g::cayley_action(S(0.5) * (first + second), mu);
  }
};

}  // namespace polhode
