// SPDX-License-Identifier: Apache-2.0
// Exact flows of the parts of h = 1/2 sum_k lambda_k mu_k^2 on so(3)*, lambda_k of any sign: a body or a spin in its
// principal axes. Each keeps |mu|.
#pragma once

#include <algorithm>

#include <polhode/lie/so3.hpp>
#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct principal_quadratic {
  vec<double, 3> lambda;

  bool spherical() const { return lambda[0] == lambda[1] && lambda[1] == lambda[2]; }

  /// The axis whose lambda is not the others'; -1 if all three differ.
  int odd_axis() const {
    for (int axis = 0; axis < 3; ++axis)
      if (lambda[(axis + 1) % 3] == lambda[(axis + 2) % 3]) return axis;
    return -1;
  }

  /// The dissipation alone, exact: mu' = theta mu x (mu x lambda mu) has mu(t) = c y/|y|, y = exp(-theta c^2 t lambda)
  /// mu(0) componentwise (double-bracket flow). The least lambda is taken out of the exponent, so nothing underflows at
  /// once.
  template <class S>
  vec<S, 3> dissipation_flow(const vec<S, 3>& mu, double theta, double t) const {
    const S c2 = dot(mu, mu);
    const auto y = weighed(mu, c2, theta * t);
    const S factor = square_root(select(c2 == S(0.0), S(1.0), S(c2 / dot(y, y))));
    return so3::orbit_projection(factor * y, mu);
  }

  /// y: the state of that flow but for its length, theta_t = theta t, of a multiple of mu and |mu|^2.
  template <class S>
  vec<S, 3> weighed(vec<S, 3> mu, const S& c2, double theta_t) const {
    const double least = std::min({lambda[0], lambda[1], lambda[2]});
    for (int k = 0; k < 3; ++k) {
      const double excess = lambda[k] - least;
      if (excess > 0) mu[k] = exponential(S(S(-theta_t * excess) * c2)) * mu[k];
    }
    return mu;
  }

  /// The free motion for a time t, to second order: rotations about the axes 1, 2 (half the time), 3 (all of it), 2, 1
  /// (half); where h is spherical nothing. Each is the exact flow of its part of h.
  template <class S>
  vec<S, 3> free_flow(vec<S, 3> mu, double t) const {
    if (spherical()) return mu;
    turn<0>(mu, t / 2);
    turn<1>(mu, t / 2);
    turn<2>(mu, t);
    turn<1>(mu, t / 2);
    turn<0>(mu, t / 2);
    return mu;
  }

  /// The same as two turns, about the axes 1 and 3: h - lambda_2 |mu|^2/2 moves mu as h does, as mu x mu = 0. Where two
  /// lambda are equal there is the first turn alone, about the odd axis.
  template <class S>
  vec<S, 3> first_turn(vec<S, 3> mu, double t) const {
    switch (odd_axis()) {
      case 1: turn<1>(mu, t, lambda[2]); break;
      case 2: turn<2>(mu, t, lambda[1]); break;
      default: turn<0>(mu, t, lambda[1]); break;
    }
    return mu;
  }
  template <class S>
  vec<S, 3> last_turn(vec<S, 3> mu, double t) const {
    if (odd_axis() < 0) turn<2>(mu, t, lambda[1]);
    return mu;
  }
  /// Half the first turn, the last, half the first: the free motion to second order; exact where there is no last.
  template <class S>
  vec<S, 3> two_turn_flow(const vec<S, 3>& mu, double t) const {
    if (odd_axis() >= 0) return first_turn(mu, t);
    return first_turn(last_turn(first_turn(mu, t / 2), t), t / 2);
  }

 private:
  template <int axis, class S>
  void turn(vec<S, 3>& mu, double t, double shift = 0) const {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const auto [sin, cos] = sincos(S(S(t * (lambda[axis] - shift)) * mu[axis]));
    const S a = mu[next], b = mu[last];
    mu[next] = a * cos + b * sin;
    mu[last] = b * cos - a * sin;
  }
};

}  // namespace polhode
