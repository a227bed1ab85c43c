// Implicit midpoint, solved by Newton's method.
//
//   m = 1/2 (mu_n + mu_{n+1}),   mu_{n+1} = mu_n + ad*_xi m,   xi = a(m) dt + sigma dW (Stratonovich)
//
// Newton on F(m) = m - mu_n - 1/2 ad*_{xi(m)} m, Jacobian by dual numbers; at the solution mu_{n+1} = Cay(xi(m)) mu_n,
// which is how it is evaluated, so that the Casimirs do not depend on the last digits of m. A fixed-point iteration
// would diverge for the larger Gaussian increments. A step whose iteration does not converge returns NaN in its lane:
// failure is data.
//
// Source: Milstein, Repin, Tretyakov, SIAM J. Numer. Anal. 40 (2002) 1583-1604 (symplectic case, truncated noise).
// Keeps every quadratic Casimir. Cost a step: per iteration one generator with Jacobian and one linear system; one
// Cayley action.
#pragma once

#include <limits>

#include <polhode/dual.hpp>
#include <polhode/schemes/scheme_info.hpp>
#include <polhode/solve.hpp>

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
  static constexpr int max_iterations = 16;
  static constexpr double tolerance =
      1e-14;  ///< on the last correction, relative to the state; it is squared by the next

  template <lie_poisson_system System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto noise = system.noise(w.dw);
    auto m = mu;
    auto pending = S(0.0) == S(0.0);
    for (int i = 0; i < max_iterations && any(S(0.0), pending); ++i) {
      const auto correction = newton_correction(system, mu, m, noise, w.dt);
      for (int k = 0; k < System::dimension; ++k) m[k] = select(pending, S(m[k] - correction[k]), m[k]);
      pending = pending && !(dot(correction, correction) <= S(tolerance * tolerance) * dot(mu, mu));
    }
    auto next = System::algebra::cayley_action(S(w.dt) * system.generator(m) + noise, mu);
    for (int k = 0; k < System::dimension; ++k)
      next[k] = select(pending, S(std::numeric_limits<double>::quiet_NaN()), next[k]);
    return next;
  }

 private:
  /// (DF)^-1 F at m.
  template <class System, class S>
  static auto newton_correction(const System& system, const vec<S, System::dimension>& mu,
                                const vec<S, System::dimension>& m, const auto& noise, double dt) {
    constexpr int n = System::dimension;
    using number = dual<S, n>;
    const auto x = seeded(m);
    auto xi = number(dt) * system.generator(x);
    for (int k = 0; k < n; ++k) xi[k].value = xi[k].value + noise[k];
    const auto force = System::algebra::coad(xi, x);
    vec<vec<S, n>, n> jacobian;
    vec<S, n> residual;
    for (int k = 0; k < n; ++k) {
      residual[k] = m[k] - mu[k] - S(0.5) * force[k].value;
      jacobian[k] = x[k].slope - S(0.5) * force[k].slope;
    }
    return solve(jacobian, residual);
  }
};

}  // namespace polhode
