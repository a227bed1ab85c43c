// SPDX-License-Identifier: Apache-2.0
// so(3) and its dual, both R^3: stateless coadjoint calculus.
//
//   [xi, eta] = xi x eta,    coad(xi, mu) = ad*_xi mu = mu x xi
//   exp_action(xi, mu): the solution at s = 1 of dmu/ds = mu x xi, the rotation of mu by -xi
//   C(eta) C(xi) - C(xi) C(eta) = C([xi, eta])  with C(xi) = coad(xi, .): the sign on which every area term rests
#pragma once

#include <polhode/lie/rotation_series.hpp>
#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct so3 {
  static constexpr int dimension = 3;

  template <class S>
  static vec<S, 3> bracket(const vec<S, 3>& xi, const vec<S, 3>& eta) {
    return cross(xi, eta);
  }

  /// ad*_xi mu = mu x xi.
  template <class S>
  static vec<S, 3> coad(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    return cross(mu, xi);
  }
  static zero_vector coad(zero_vector, const auto&) { return {}; }

  /// Ad*_exp(xi) mu = mu + sinc(t) mu x xi + (1 - cos t)/t^2 (mu x xi) x xi, t = |xi| (Rodrigues). Any finite xi whose
  /// square is finite.
  template <class S>
  static vec<S, 3> exp_action(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const auto [first, second] = rotation_series<7, 1.0>::of(dot(xi, xi));
    return rotated(first, second, xi, mu);
  }

  template <class S>
  static vec<S, 3> exp_action(zero_vector, const vec<S, 3>& mu) {
    return mu;
  }

  /// Cayley action: (1 - C/2)^-1 (1 + C/2) mu, C = coad(xi, .). A rotation by 2 atan(|xi|/2), no transcendental
  /// function.
  template <class S>
  static vec<S, 3> cayley_action(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const S factor = S(1.0) / (S(1.0) + S(0.25) * dot(xi, xi));
    return rotated(factor, S(S(0.5) * factor), xi, mu);
  }

  /// -X M X of the matrices of xi x and mu x: (xi.mu) xi.
  template <class S>
  static vec<S, 3> sandwich(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    return dot(xi, mu) * xi;
  }

  /// Inverse of the differential of exp: sum_k B_k/k! ad_u^k v = v - [u,v]/2 + (1 - (t/2) cot(t/2))/t^2 [u,[u,v]],
  /// t = |u| < 2 pi. Source: Iserles, Munthe-Kaas, Norsett, Zanna, Lie-group methods, Acta Numerica 9 (2000), App. B.
  template <class S>
  static vec<S, 3> dexp_inv(const vec<S, 3>& u, const vec<S, 3>& v) {
    const S q = dot(u, u);
    const S half = S(0.5) * square_root(q);
    const auto [sin, cos] = sincos(half);
    // Below q = 0.04 the closed form cancels; the series sum_k |B_2k|/(2k)! q^(k-1) is exact to rounding there.
    const S series =
        S(1.0 / 12) + q * (S(1.0 / 720) + q * (S(1.0 / 30240) + q * (S(1.0 / 1209600) + q * S(1.0 / 47900160))));
    const S factor = select(q < S(0.04), series, S((S(1.0) - half * cos / sin) / q));
    const auto uv = cross(u, v);
    return v - S(0.5) * uv + factor * cross(u, uv);
  }

  /// The Casimir whose level sets are the coadjoint orbits, as a length: |mu|.
  template <class S>
  static vec<S, 1> casimirs(const vec<S, 3>& mu) {
    return {{square_root(dot(mu, mu))}};
  }

  /// The point of the orbit of `onto` nearest to mu: |onto|/|mu| mu. Near the orbit it is written as a small correction
  /// of mu, as a factor near 1 would be rounded to the same side step after step and let the orbit drift like the
  /// number of steps; far from it that would cancel. Of the zero vector itself.
  template <class S>
  static vec<S, 3> orbit_projection(const vec<S, 3>& mu, const vec<S, 3>& onto) {
    const S own = dot(mu, mu);
    const S square = select(own == S(0.0), S(1.0), own);
    const S excess = dot(onto - mu, onto + mu) / square;  // |onto|^2/|mu|^2 - 1
    // sqrt(1 + excess) - 1
    const S correction =
        excess *
        (S(0.5) - excess * (S(0.125) - excess * (S(0.0625) - excess * (S(5.0 / 128) - excess * S(7.0 / 256)))));
    auto out = mu + correction * mu;
    if (any(excess, magnitude(excess) > S(near_orbit))) [[unlikely]]
      project_far(mu, S(dot(onto, onto) / square), excess, out);
    return out;
  }

 private:
  static constexpr double near_orbit = 1e-3;  ///< the next term is 2e-20: what all steps leave out adds up, unrounded
  template <class S>
  [[gnu::cold, gnu::noinline]] static void project_far(const vec<S, 3>& mu, const S& ratio, const S& excess,
                                                       vec<S, 3>& out) {
    const S correction = excess / (S(1.0) + square_root(S(1.0) + excess)), factor = square_root(ratio);
    for (int k = 0; k < 3; ++k) {
      const S there = select(magnitude(excess) < S(0.1), S(mu[k] + correction * mu[k]), S(factor * mu[k]));
      out[k] = select(magnitude(excess) > S(near_orbit), there, out[k]);
    }
  }

 protected:
  template <class S>
  static vec<S, 3> rotated(const S& first, const S& second, const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const auto once = coad(xi, mu);
    return mu + (first * once + second * coad(xi, once));
  }
};

}  // namespace polhode
