// SPDX-License-Identifier: Apache-2.0
// Isospectral midpoint: the symplectic midpoint rule after reduction, free of exponentials.
//
//   mu_n = (1 + X/2) M (1 - X/2),   mu_{n+1} = (1 - X/2) M (1 + X/2),   X = a(M) dt + sum sigma_i(M) dW^i
//
// as matrices, where the dual of the algebra is the algebra: m = mu_n + 1/2 (ad*_xi m - 1/2 s(xi, m)), s(xi, m) = -X M
// X. At the solution mu_{n+1} = Ad*_Cay(xi(m)) mu_n, which is how it is evaluated. Without dissipation each step is a
// Poisson map, noise of Hamiltonians that are functions of the state included; the implicit midpoint rule's is not.
//
// Source: Ephrati, Jansson, Lang, Luesink, arXiv:2408.16701; Modin, Viviani, J. Geom. Phys. 155 (2020) 103741 (without
// noise). Keeps every Casimir. Cost a step: as implicit_midpoint, and a generator a motion.
#pragma once

#include <polhode/schemes/midpoint_solver.hpp>

namespace polhode {

/// An algebra of matrices that is its own dual and closed under s(xi, mu) = -X M X; su(n) is not, for its trace.
template <class G>
concept isospectral_algebra = requires(const vec<double, G::dimension>& v) {
  { G::sandwich(v, v) } -> std::same_as<vec<double, G::dimension>>;
};

struct isospectral_midpoint {
  static constexpr scheme_info info{.name = "isospectral_midpoint",
                                    .title = "Isospectral midpoint, Newton",
                                    .source = "Ephrati, Jansson, Lang, Luesink 2024",
                                    .calculus = calculus::stratonovich,
                                    .strong_order = {.commuting = 1, .general = 0.5},
                                    .weak_order = {.one_vector = 1, .isotropic = 1, .general = 1},
                                    .deterministic_order = 2,
                                    .casimir = keeps_casimirs,
                                    .action = group_action::cayley,
                                    .implicit = true,
                                    .poisson = true};
  static constexpr std::string_view needs = "an algebra of matrices that is its own dual and closed under X M X";

  template <lie_poisson_system System, class S>
  requires isospectral_algebra<typename System::algebra>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return midpoint_solver<isospectral_midpoint>::cayley_step(system, mu, w);
  }

  template <class System, class S>
  static auto motion(const System& system, const vec<S, System::dimension>& m, const wiener<S, System::channels>& w) {
    return contracted_motion(system, m, w);
  }
  template <class System, class S>
  static auto linearised_motion(const System& system, const vec<S, System::dimension>& m,
                                const wiener<S, System::channels>& w) {
    return linearised_contracted_motion(system, m, w);
  }
};

}  // namespace polhode
