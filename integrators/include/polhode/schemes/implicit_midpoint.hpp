// SPDX-License-Identifier: Apache-2.0
// Implicit midpoint, solved by Newton's method.
//
//   m = 1/2 (mu_n + mu_{n+1}),   mu_{n+1} = mu_n + ad*_xi m,   xi = a(m) dt + sigma dW (Stratonovich)
//
// At the solution mu_{n+1} = Cay(xi(m)) mu_n, which is how it is evaluated.
//
// Source: Milstein, Repin, Tretyakov, SIAM J. Numer. Anal. 40 (2002) 1583-1604 (symplectic case, truncated noise).
// Keeps every quadratic Casimir. Cost a step: one motion with its derivative, one inverse of that, two to eight
// motions; one Cayley action.
#pragma once

#include <polhode/schemes/midpoint_solver.hpp>

namespace polhode {

struct implicit_midpoint {
  static constexpr scheme_info info{.name = "implicit_midpoint",
                                    .title = "Implicit midpoint, Newton",
                                    .source = "Milstein, Repin, Tretyakov 2002",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::cayley,
                                    .implicit = true};

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return midpoint_solver<implicit_midpoint>::cayley_step(system, mu, w);
  }

  template <class System, class S>
  static auto motion(const System& system, const vec<S, System::dimension>& m, const wiener<S, System::channels>& w) {
    return polhode::motion(system, m, w);
  }
  template <class System, class S>
  static auto linearised_motion(const System& system, const vec<S, System::dimension>& m,
                                const wiener<S, System::channels>& w) {
    return polhode::linearised_motion(system, m, w);
  }
};

}  // namespace polhode
