// SPDX-License-Identifier: Apache-2.0
// so(3)^N, N spins or vortices, and its dual, R^3 x … x R^3: every operation factor by factor. N is known at run time:
// the size of a vector over three.
#pragma once

#include <polhode/called.hpp>
#include <polhode/lie/so3.hpp>

namespace polhode {

/// At most `most` factors.
template <int most>
struct so3_power {
  static constexpr int dimension = -3 * most;
  template <class S>
  using element = vec<S, dimension>;

  template <class S>
  static vec<S, 3> part(const element<S>& v, int which) {
    return {{v[3 * which], v[3 * which + 1], v[3 * which + 2]}};
  }
  template <class S>
  static void set_part(element<S>& v, int which, const vec<S, 3>& x) {
    for (int k = 0; k < 3; ++k) v[3 * which + k] = x[k];
  }

  template <class S>
  static element<S> bracket(const element<S>& xi, const element<S>& eta) {
    return each([](const auto& a, const auto& b) { return so3::bracket(a, b); }, xi, eta);
  }
  template <class S>
  POLHODE_CALLED static element<S> coad(const element<S>& xi, const element<S>& mu) {
    return each([](const auto& a, const auto& b) { return so3::coad(a, b); }, xi, mu);
  }
  template <class S>
  POLHODE_CALLED static element<S> exp_action(const element<S>& xi, const element<S>& mu) {
    return each([](const auto& a, const auto& b) { return so3::exp_action(a, b); }, xi, mu);
  }
  template <class S>
  POLHODE_CALLED static element<S> cayley_action(const element<S>& xi, const element<S>& mu) {
    return each([](const auto& a, const auto& b) { return so3::cayley_action(a, b); }, xi, mu);
  }
  template <class S>
  POLHODE_CALLED static element<S> sandwich(const element<S>& xi, const element<S>& mu) {
    return each([](const auto& a, const auto& b) { return so3::sandwich(a, b); }, xi, mu);
  }
  template <class S>
  POLHODE_CALLED static element<S> dexp_inv(const element<S>& u, const element<S>& v) {
    return each([](const auto& a, const auto& b) { return so3::dexp_inv(a, b); }, u, v);
  }
  template <class S>
  POLHODE_CALLED static element<S> orbit_projection(const element<S>& mu, const element<S>& onto) {
    return each([](const auto& a, const auto& b) { return so3::orbit_projection(a, b); }, mu, onto);
  }

  /// The lengths of the parts: an orbit is a product of spheres.
  template <class S>
  static vec<S, -most> casimirs(const element<S>& mu) {
    vec<S, -most> out(mu.size / 3);
    for (int i = 0; i < out.size; ++i) out[i] = so3::casimirs(part(mu, i))[0];
    return out;
  }

 private:
  template <class F, class S>
  static element<S> each(F f, const element<S>& a, const element<S>& b) {
    element<S> out(b.size);
    for (int i = 0; i < b.size / 3; ++i) set_part(out, i, f(part(a, i), part(b, i)));
    return out;
  }
};

}  // namespace polhode
