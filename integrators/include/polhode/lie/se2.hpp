// SPDX-License-Identifier: Apache-2.0
// se(2), turns and shifts of the plane, and its dual: mu = (m, p), xi = (omega, v), m and omega numbers, p and v in
// R^2.
//
//   coad(xi, mu) = ad*_xi mu = (p x v, omega J p),   [(omega, v), (eta, w)] = (0, J^-1 (omega w - eta v)),
//   p x v = p_1 v_2 - p_2 v_1,   J (a, b) = (b, -a)
//
// The Casimir is |p|: orbits are cylinders, so not compact. Sign convention as in lie/so3.hpp.
#pragma once

#include <polhode/lie/so3.hpp>
#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct se2 {
  static constexpr int dimension = 3;

  template <class S>
  static vec<S, 3> bracket(const vec<S, 3>& xi, const vec<S, 3>& eta) {
    const S a = xi[0] * eta[1] - eta[0] * xi[1], b = xi[0] * eta[2] - eta[0] * xi[2];
    return {{S(0.0), -b, a}};
  }

  template <class S>
  static vec<S, 3> coad(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    return {{mu[1] * xi[2] - mu[2] * xi[1], xi[0] * mu[2], -(xi[0] * mu[1])}};
  }

  /// p turns by omega, and m gains the mean of p on its way x v: sinc(omega) p + omega/2 sinc(omega/2)^2 J p.
  template <class S>
  static vec<S, 3> exp_action(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const S half = S(0.5) * xi[0];
    const auto [sin, cos] = sincos(half);
    const S sinc = select(half == S(0.0), S(1.0), S(sin / half));
    const S along = sinc * cos, across = half * sinc * sinc;
    const S a = mu[1], b = mu[2];
    const S mean_a = along * a + across * b, mean_b = along * b - across * a;
    return {{mu[0] + (mean_a * xi[2] - mean_b * xi[1]), a + xi[0] * mean_b, b - xi[0] * mean_a}};
  }

  /// (1 - C/2)^-1 (1 + C/2) mu, C = coad(xi, .): p turns by 2 atan(omega/2), and m gains the mean of both ends x v.
  template <class S>
  static vec<S, 3> cayley_action(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const S half = S(0.5) * xi[0];
    const S factor = S(1.0) / (S(1.0) + half * half);
    const S a = mu[1], b = mu[2];
    const S mean_a = factor * (a + half * b), mean_b = factor * (b - half * a);
    return {{mu[0] + (mean_a * xi[2] - mean_b * xi[1]), a + xi[0] * mean_b, b - xi[0] * mean_a}};
  }

  /// Inverse of the differential of exp, |omega_u| < 2 pi: with (0, w) = [u, v], v + (0, -w/2 + s omega_u J^-1 w), s =
  /// (1 - (t/2) cot(t/2)) / t^2 at t = omega_u.
  template <class S>
  static vec<S, 3> dexp_inv(const vec<S, 3>& u, const vec<S, 3>& v) {
    const S q = u[0] * u[0], half = S(0.5) * u[0];
    const auto [sin, cos] = sincos(half);
    // As in lie/so3.hpp: below q = 0.04 the closed form cancels.
    const S series =
        S(1.0 / 12) + q * (S(1.0 / 720) + q * (S(1.0 / 30240) + q * (S(1.0 / 1209600) + q * S(1.0 / 47900160))));
    const S factor = u[0] * select(q < S(0.04), series, S((S(1.0) - half * cos / sin) / q));
    const auto w = bracket(u, v);
    return v - S(0.5) * w + factor * vec<S, 3>{{S(0.0), -w[2], w[1]}};
  }

  template <class S>
  static vec<S, 1> casimirs(const vec<S, 3>& mu) {
    return {{square_root(mu[1] * mu[1] + mu[2] * mu[2])}};
  }

  /// p to the length of that of `onto`; of a state with p = 0 itself.
  template <class S>
  static vec<S, 3> orbit_projection(const vec<S, 3>& mu, const vec<S, 3>& onto) {
    const auto plane = [](const vec<S, 3>& x) { return vec<S, 3>{{S(0.0), x[1], x[2]}}; };
    const auto p = so3::orbit_projection(plane(mu), plane(onto));
    return {{mu[0], p[1], p[2]}};
  }
};

}  // namespace polhode
