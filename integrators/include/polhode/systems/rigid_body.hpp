// SPDX-License-Identifier: Apache-2.0
// The dissipative stochastic rigid body on so(3)* (Arnaudon, De Castro, Holm, arXiv:1606.06308, eq. 3.4).
//
//   dPi = Pi x (Omega + theta Pi x Omega) dt + sum_i Pi x sigma_i o dW^i,   Omega = Pi / I,   h = 1/2 Pi . Omega
//
// Sign: the paper prints dPi + Pi x Omega dt + theta Pi x (Pi x Omega) dt + … = 0. Read literally that makes h grow.
// With the sign used here, and only with it, both laws of the paper hold: dh/dt = -theta |Pi x Omega|^2 without noise
// (eq. 3.5) and the stationary density exp(-2 theta h / sigma^2) (eq. 3.8).
#pragma once

#include <array>
#include <utility>

#include <polhode/lie/so3.hpp>
#include <polhode/systems/double_bracket.hpp>
#include <polhode/systems/principal_quadratic.hpp>

namespace polhode {

struct rigid_body : double_bracket<rigid_body, so3> {
  /// Moments of inertia > 0, theta >= 0.
  rigid_body(const std::array<double, 3>& inertia, double dissipation, constant_noise<so3> noise_vectors)
      : double_bracket(dissipation, std::move(noise_vectors)),
        inverse_inertia{{1 / inertia[0], 1 / inertia[1], 1 / inertia[2]}} {}

  vec<double, 3> inverse_inertia;

  template <class S>
  vec<S, 3> omega(const vec<S, 3>& pi) const {
    return scaled(inverse_inertia, pi);
  }

  template <class S>
  S energy(const vec<S, 3>& pi) const {
    return S(0.5) * dot(pi, omega(pi));
  }

  /// The parts' flows: see principal_quadratic.
  template <class S>
  vec<S, 3> dissipation_flow(const vec<S, 3>& pi, double t) const {
    return theta == 0 ? pi : principal().dissipation_flow(pi, theta, t);
  }
  template <class S>
  vec<S, 3> free_flow(const vec<S, 3>& pi, double t) const {
    return principal().free_flow(pi, t);
  }
  template <class S>
  vec<S, 3> first_turn(const vec<S, 3>& pi, double t) const {
    return principal().first_turn(pi, t);
  }
  template <class S>
  vec<S, 3> last_turn(const vec<S, 3>& pi, double t) const {
    return principal().last_turn(pi, t);
  }

  /// Of a symmetric body the axis whose moment of inertia is not the others'; -1 if all three differ.
  int odd_axis() const { return principal().odd_axis(); }

 private:
  principal_quadratic principal() const { return {inverse_inertia}; }
};

}  // namespace polhode
