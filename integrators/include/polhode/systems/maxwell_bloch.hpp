// SPDX-License-Identifier: Apache-2.0
// The real Maxwell-Bloch equations on the dual of se(2): mu = (x_1, x_2, x_3),
//
//   x_1' = x_2,   x_2' = x_1 x_3,   x_3' = -x_1 x_2,   h = x_1^2 / 2 + x_3,   Casimir |(x_2, x_3)|,
//
// with double-bracket dissipation and noise as in double_bracket.hpp: dmu = ad*_{Omega + theta ad*_Omega mu} mu dt +
// sum_i ad*_{sigma_i} mu o dW^i, Omega = grad h = (x_1, 0, 1). x_1 is the field, (x_2, x_3) polarisation and
// inversion of the atoms; the same equations are those of a pendulum. Source: David, Holm, J. Nonlinear Sci. 2 (1992)
// 241-262; Arnaudon, De Castro, Holm, arXiv:1601.02249.
#pragma once

#include <utility>

#include <polhode/lie/se2.hpp>
#include <polhode/systems/double_bracket.hpp>

namespace polhode {

struct maxwell_bloch : double_bracket<maxwell_bloch, se2> {
  static constexpr bool approximate_dissipation = true;

  /// theta >= 0.
  maxwell_bloch(double dissipation, constant_noise<se2> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)) {}

  template <class S>
  vec<S, 3> omega(const vec<S, 3>& mu) const {
    return {{mu[0], S(0.0), S(1.0)}};
  }
  template <class S>
  S energy(const vec<S, 3>& mu) const {
    return S(0.5) * mu[0] * mu[0] + mu[2];
  }

  /// The dissipation alone, to second order: the mean of its generators at both ends of an Euler step, as one
  /// exponential.
  template <class S>
  vec<S, 3> dissipation_flow(const vec<S, 3>& mu, double t) const {
    if (theta == 0) return mu;
    return averaged_flow<se2>([&](const vec<S, 3>& x) { return S(theta * t) * se2::coad(omega(x), x); }, mu);
  }
  /// The motion without dissipation, to second order.
  template <class S>
  vec<S, 3> free_flow(const vec<S, 3>& mu, double t) const {
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }
  /// The flow of x_3, exact: x_1 grows by t x_2.
  template <class S>
  vec<S, 3> first_turn(const vec<S, 3>& mu, double t) const {
    return {{mu[0] + S(t) * mu[1], mu[1], mu[2]}};
  }
  /// The flow of x_1^2 / 2, exact: (x_2, x_3) turns by t x_1.
  template <class S>
  vec<S, 3> last_turn(const vec<S, 3>& mu, double t) const {
    return se2::exp_action(vec<S, 3>{{S(t) * mu[0], S(0.0), S(0.0)}}, mu);
  }
};

}  // namespace polhode
