// SPDX-License-Identifier: Apache-2.0
// so(4) = so(3) + so(3) and its dual, R^3 x R^3: every operation factor by factor.
#pragma once

#include <polhode/lie/so3.hpp>

namespace polhode {

struct so4 {
  static constexpr int dimension = 6;

  template <class S>
  static vec<S, 3> part(const vec<S, 6>& v, int which) {
    return {{v[3 * which], v[3 * which + 1], v[3 * which + 2]}};
  }
  template <class S>
  static void set_part(vec<S, 6>& v, int which, const vec<S, 3>& x) {
    for (int k = 0; k < 3; ++k) v[3 * which + k] = x[k];
  }
  template <class S>
  static vec<S, 6> joined(const vec<S, 3>& a, const vec<S, 3>& b) {
    return {{a[0], a[1], a[2], b[0], b[1], b[2]}};
  }

  template <class S>
  static vec<S, 6> bracket(const vec<S, 6>& xi, const vec<S, 6>& eta) {
    return both([](auto a, auto b) { return so3::bracket(a, b); }, xi, eta);
  }
  template <class S>
  static vec<S, 6> coad(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    return both([](auto a, auto b) { return so3::coad(a, b); }, xi, mu);
  }
  template <class S>
  static vec<S, 6> exp_action(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    return both([](auto a, auto b) { return so3::exp_action(a, b); }, xi, mu);
  }
  template <class S>
  static vec<S, 6> cayley_action(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    return both([](auto a, auto b) { return so3::cayley_action(a, b); }, xi, mu);
  }
  template <class S>
  static vec<S, 6> sandwich(const vec<S, 6>& xi, const vec<S, 6>& mu) {
    return both([](auto a, auto b) { return so3::sandwich(a, b); }, xi, mu);
  }
  template <class S>
  static vec<S, 6> dexp_inv(const vec<S, 6>& u, const vec<S, 6>& v) {
    return both([](auto a, auto b) { return so3::dexp_inv(a, b); }, u, v);
  }
  template <class S>
  static vec<S, 6> orbit_projection(const vec<S, 6>& mu, const vec<S, 6>& onto) {
    return both([](auto a, auto b) { return so3::orbit_projection(a, b); }, mu, onto);
  }

  /// The lengths of the two parts: an orbit is a product of two spheres.
  template <class S>
  static vec<S, 2> casimirs(const vec<S, 6>& mu) {
    return {{so3::casimirs(part(mu, 0))[0], so3::casimirs(part(mu, 1))[0]}};
  }

 private:
  template <class F, class S>
  static vec<S, 6> both(F f, const vec<S, 6>& a, const vec<S, 6>& b) {
    return joined(f(part(a, 0), part(b, 0)), f(part(a, 1), part(b, 1)));
  }
};

}  // namespace polhode
