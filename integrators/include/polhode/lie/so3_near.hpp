// SPDX-License-Identifier: Apache-2.0
// so(3) for rotations that are mostly small: the coadjoint calculus of so3.hpp with exp by polynomials of a lower
// degree, to the same accuracy.
#pragma once

#include <polhode/lie/rotation_series.hpp>
#include <polhode/lie/so3.hpp>

namespace polhode {

/// Degree and reach as in rotation_series.hpp.
template <int degree, double reach>
struct so3_near : so3 {
  using so3::exp_action;

  template <class S>
  static vec<S, 3> exp_action(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const auto [first, second] = rotation_series<degree, reach>::of(dot(xi, xi));
    return rotated(first, second, xi, mu);
  }
};

}  // namespace polhode
