// SPDX-License-Identifier: Apache-2.0
// se(3), the semidirect sum of so(3) and R^3, and its dual: mu = (Pi, Gamma), xi = (omega, v), six numbers each.
//
//   [(omega, v), (omega', v')] = (omega x omega', omega x v' - omega' x v)
//   coad(xi, mu) = ad*_xi mu = (Pi x omega + Gamma x v, Gamma x omega)
//   Casimirs |Gamma| and Pi.Gamma: the orbits are the cotangent bundles of spheres, so not compact.
//
// Sign convention as in lie/so3.hpp. Source: Holm, Marsden, Ratiu, Adv. Math. 137 (1998) 1-81, section 7 (heavy top).
#pragma once

#include <polhode/lie/so3.hpp>
#include <polhode/lie/so4.hpp>

namespace polhode {

struct se3 {
  static constexpr int dimension = 6;

  template <class S>
  static vec<S, 6> bracket(const vec<S, 6>& xi, const vec<S, 6>& eta) {
    return joined(cross(turn(xi), turn(eta)), cross(turn(xi), shift(eta)) - cross(turn(eta), shift(xi)));
  }

  template <class S>
  static vec<S, 6> coad(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    return joined(cross(pi(mu), turn(xi)) + cross(gamma(mu), shift(xi)), cross(gamma(mu), turn(xi)));
  }

  /// Both parts are rotated by -omega; then Pi gains Gamma(1) x int_0^1 exp(-s omega^) v ds.
  template <class S>
  static vec<S, 6> exp_action(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    const auto w = turn(xi), v = shift(xi);
    const auto [first, second, third] = rotation_series<7, 1.0, 3>::of(dot(w, w));
    const auto wv = cross(w, v);
    const auto after = rotated(first, second, w, gamma(mu));
    return joined(rotated(first, second, w, pi(mu)) + cross(after, v - second * wv + third * cross(w, wv)), after);
  }

  /// (1 - C/2)^-1 (1 + C/2) mu, C = coad(xi, .): keeps |Gamma| and Pi.Gamma, as any Cayley transform keeps quadratic
  /// invariants.
  template <class S>
  static vec<S, 6> cayley_action(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    const auto w = turn(xi);
    const auto after = so3::cayley_action(w, gamma(mu));
    // y - y x w / 2 = x has y = (x + x x w / 2 + w (w.x) / 4) / (1 + |w|^2 / 4).
    const auto x = cross(S(0.5) * (gamma(mu) + after), shift(xi));
    const S factor = S(1.0) / (S(1.0) + S(0.25) * dot(w, w));
    const auto gained = factor * (x + S(0.5) * cross(x, w) + S(S(0.25) * dot(w, x)) * w);
    return joined(so3::cayley_action(w, pi(mu)) + gained, after);
  }

  /// Inverse of the differential of exp, |turn(u)| < 2 pi. With z = ad_u^2, of eigenvalues 0 and twice -q, q =
  /// |turn(u)|^2: v - [u,v]/2 + (s - z s') z v + s' z^2 v, where s(z) = (sqrt(z)/2 coth(sqrt(z)/2) - 1) / z at z = -q.
  template <class S>
  static vec<S, 6> dexp_inv(const vec<S, 6>& u, const vec<S, 6>& v) {
    const auto w = turn(u);
    const S q = dot(w, w), half = S(0.5) * square_root(q);
    const auto [sin, cos] = sincos(half);
    // sum_k |B_2k|/(2k)! q^(k-1) and its derivative, exact to rounding below q = 0.04.
    constexpr double b[] = {1.0 / 12, 1.0 / 720, 1.0 / 30240, 1.0 / 1209600, 1.0 / 47900160, 691.0 / 1307674368000.0};
    S value = S(b[5]), slope = S(5 * b[5]);
    for (int k = 4; k >= 0; --k) value = S(b[k]) + q * value;
    for (int k = 4; k >= 1; --k) slope = S(k * b[k]) + q * slope;
    const S cot = cos / sin;
    const S closed = (S(1.0) - half * cot) / q;
    const S closed_slope = (S(0.0) - closed - (cot - half / (sin * sin)) / (S(8.0) * half)) / q;
    const auto small = q < S(0.04);
    const S s = select(small, value, closed), ds = select(small, slope, closed_slope);  // ds = ds/dq = -s'(z)
    const auto once = bracket(u, v), twice = bracket(u, once);
    const auto fourfold = bracket(u, bracket(u, twice));
    return v - S(0.5) * once + S(s - q * ds) * twice - ds * fourfold;
  }

  /// |Gamma| and Pi.Gamma.
  template <class S>
  static vec<S, 2> casimirs(const vec<S, 6>& mu) {
    return {{so3::casimirs(gamma(mu))[0], dot(pi(mu), gamma(mu))}};
  }

  /// What a change of each is measured by: Pi.Gamma may be zero.
  template <class S>
  static vec<S, 2> casimir_sizes(const vec<S, 6>& mu) {
    const S length = so3::casimirs(gamma(mu))[0];
    return {{length, square_root(dot(mu, mu)) * length}};
  }

  /// A point of the orbit of `onto` next to mu: Gamma to its length, then Pi along Gamma. Of states with a Gamma.
  template <class S>
  static vec<S, 6> orbit_projection(const vec<S, 6>& mu, const vec<S, 6>& onto) {
    const auto there = so3::orbit_projection(gamma(mu), gamma(onto));
    const S square = dot(there, there);
    const S missing = dot(pi(onto), gamma(onto)) - dot(pi(mu), there);
    return joined(pi(mu) + select(square == S(0.0), S(0.0), S(missing / square)) * there, there);
  }

  // The parts of mu, those of xi, and both joined.
  template <class S>
  static vec<S, 3> pi(const vec<S, 6>& mu) {
    return so4::part(mu, 0);
  }
  template <class S>
  static vec<S, 3> gamma(const vec<S, 6>& mu) {
    return so4::part(mu, 1);
  }
  template <class S>
  static vec<S, 3> turn(const vec<S, 6>& xi) {
    return so4::part(xi, 0);
  }
  template <class S>
  static vec<S, 3> shift(const vec<S, 6>& xi) {
    return so4::part(xi, 1);
  }
  template <class S>
  static vec<S, 6> joined(const vec<S, 3>& a, const vec<S, 3>& b) {
    return so4::joined(a, b);
  }

 private:
  template <class S>
  static vec<S, 3> rotated(const S& first, const S& second, const vec<S, 3>& w, const vec<S, 3>& x) {
    const auto once = cross(x, w);
    return x + (first * once + second * cross(once, w));
  }
};

}  // namespace polhode
