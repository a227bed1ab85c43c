// The dissipative stochastic rigid body on so(3)* (Arnaudon, De Castro, Holm, arXiv:1606.06308, eq. 3.4).
//
//   dPi = Pi x (Omega + theta Pi x Omega) dt + sum_i Pi x sigma_i o dW^i,   Omega = Pi / I,   h = 1/2 Pi . Omega
//
// Sign: the paper prints dPi + Pi x Omega dt + theta Pi x (Pi x Omega) dt + … = 0. Read literally that makes h grow.
// With the sign used here, and only with it, both laws of the paper hold: dh/dt = -theta |Pi x Omega|^2 without noise
// (eq. 3.5) and the stationary density exp(-2 theta h / sigma^2) (eq. 3.8).
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include <polhode/lie/so3.hpp>
#include <polhode/systems/constant_noise.hpp>
#include <polhode/systems/lie_poisson.hpp>

namespace polhode {

struct rigid_body : constant_noise<so3> {
  using algebra = so3;

  /// Moments of inertia > 0, theta >= 0.
  rigid_body(const std::array<double, 3>& inertia, double dissipation, constant_noise<so3> noise_vectors)
      : constant_noise(std::move(noise_vectors)),
        inverse_inertia{{1 / inertia[0], 1 / inertia[1], 1 / inertia[2]}},
        theta(dissipation) {}

  vec<double, 3> inverse_inertia;
  double theta;

  rigid_body with_noise(constant_noise<so3> other) const {
    rigid_body copy = *this;
    static_cast<constant_noise<so3>&>(copy) = std::move(other);
    return copy;
  }

  template <class S>
  vec<S, 3> omega(const vec<S, 3>& pi) const {
    return scaled(inverse_inertia, pi);
  }

  template <class S>
  S energy(const vec<S, 3>& pi) const {
    return S(0.5) * dot(pi, omega(pi));
  }

  /// -dh/dt without noise: theta |Pi x Omega|^2 (eq. 3.5).
  template <class S>
  S dissipation_rate(const vec<S, 3>& pi) const {
    const auto c = cross(pi, omega(pi));
    return S(theta) * dot(c, c);
  }

  /// a(Pi) = Omega + theta Pi x Omega.
  template <class S>
  vec<S, 3> generator(const vec<S, 3>& pi) const {
    const auto w = omega(pi);
    return w + S(theta) * cross(pi, w);
  }

  /// The dissipation alone, exact: Pi' = theta Pi x (Pi x Omega) has Pi(t) = c y/|y|, y = exp(-theta c^2 t / I) Pi(0)
  /// componentwise (double-bracket flow). The least of 1/I is taken out of the exponent, so nothing underflows at once.
  template <class S>
  vec<S, 3> dissipation_flow(const vec<S, 3>& pi, double t) const {
    if (theta == 0) return pi;
    const S c2 = dot(pi, pi);
    const double least = std::min({inverse_inertia[0], inverse_inertia[1], inverse_inertia[2]});
    vec<S, 3> y = pi;
    for (int k = 0; k < 3; ++k) {
      const double excess = inverse_inertia[k] - least;
      if (excess > 0) y[k] = exponential(S(S(-theta * t * excess) * c2)) * pi[k];
    }
    return square_root(c2 / dot(y, y)) * y;
  }

  /// The free rotation for a time t, to second order and on the sphere: rotations about the axes 1, 2 (half the time),
  /// 3 (all of it), 2, 1 (half); of a spherical body nothing. Each is the exact flow of its part Pi_j^2 / 2 I_j of the
  /// energy.
  template <class S>
  vec<S, 3> free_flow(vec<S, 3> pi, double t) const {
    if (inverse_inertia[0] == inverse_inertia[1] && inverse_inertia[1] == inverse_inertia[2]) return pi;
    turn<0>(pi, t / 2);
    turn<1>(pi, t / 2);
    turn<2>(pi, t);
    turn<1>(pi, t / 2);
    turn<0>(pi, t / 2);
    return pi;
  }

  /// The free motion as two turns, about the axes 1 and 3: h - |Pi|^2/2I_2 moves Pi as h does, as Pi x Pi = 0. A
  /// symmetric body has the first turn alone, about its odd axis, and a spherical one none.
  template <class S>
  vec<S, 3> first_turn(vec<S, 3> pi, double t) const {
    switch (odd_axis()) {
      case 1: turn<1>(pi, t, inverse_inertia[2]); break;
      case 2: turn<2>(pi, t, inverse_inertia[1]); break;
      default: turn<0>(pi, t, inverse_inertia[1]); break;
    }
    return pi;
  }
  template <class S>
  vec<S, 3> last_turn(vec<S, 3> pi, double t) const {
    if (odd_axis() < 0) turn<2>(pi, t, inverse_inertia[1]);
    return pi;
  }

  /// Of a symmetric body the axis whose moment of inertia is not the others'; -1 if all three differ.
  int odd_axis() const {
    for (int axis = 0; axis < 3; ++axis)
      if (inverse_inertia[(axis + 1) % 3] == inverse_inertia[(axis + 2) % 3]) return axis;
    return -1;
  }

 private:
  template <int axis, class S>
  void turn(vec<S, 3>& pi, double t, double shift = 0) const {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const auto [sin, cos] = sincos(S(S(t * (inverse_inertia[axis] - shift)) * pi[axis]));
    const S a = pi[next], b = pi[last];
    pi[next] = a * cos + b * sin;
    pi[last] = b * cos - a * sin;
  }
};

}  // namespace polhode
