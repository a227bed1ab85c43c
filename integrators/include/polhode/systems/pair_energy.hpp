// SPDX-License-Identifier: Apache-2.0
// The energy f(u), u = S_i.S_j, of a pair of spins: of exchange, or of two point vortices.
//
//   exchange  f = J u                                f'(u) = J
//   vortices  f = -(Gamma_i Gamma_j / 4 pi) log g    f'(u) = 1 / (4 pi g),   g = 1 - u / Gamma_i Gamma_j
//
// g is half the square of the distance of S_i / Gamma_i and S_j / Gamma_j, which does not cancel where they are close.
// Where two vortices meet g = 0: the force there is infinite, and so is the next state.
#pragma once

#include <limits>
#include <numbers>

#include <polhode/lie/rotation_series.hpp>
#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct pair_energy {
  int i, j;
  double strength;                  ///< J
  double gamma_i = 0, gamma_j = 0;  ///< 0: exchange

  static pair_energy of_vortices(int i, int j, double gamma_i, double gamma_j) { return {i, j, 0, gamma_i, gamma_j}; }
  bool is_exchange() const { return gamma_i == 0; }

  /// f'(u) at S_i = a, S_j = b.
  template <class S>
  S slope(const vec<S, 3>& a, const vec<S, 3>& b) const {
    if (is_exchange()) return S(strength);
    return S(1 / (4 * std::numbers::pi)) / gap(a, b);
  }
  /// f. Not finite at g = 0, or where g is no number.
  template <class S>
  S value(const vec<S, 3>& a, const vec<S, 3>& b) const {
    if (is_exchange()) return S(strength) * dot(a, b);
    const S g = gap(a, b);
    const S log = select(g > S(0.0), logarithm(g), S(-std::numeric_limits<double>::infinity()));
    return S(-gamma_i * gamma_j / (4 * std::numbers::pi)) * log;
  }

 private:
  template <class S>
  S gap(const vec<S, 3>& a, const vec<S, 3>& b) const {
    const auto apart = S(1 / gamma_i) * a - S(1 / gamma_j) * b;
    return S(0.5) * dot(apart, apart);
  }
};

/// What a gains, and b loses, where both turn about their sum: Ad*_exp(k (a + b)) of each. The sum stays.
template <class S>
vec<S, 3> gained_about_sum(const S& k, const vec<S, 3>& a, const vec<S, 3>& b) {
  const auto axis = k * (a + b), across = k * cross(a, b);  // a x axis, and axis x b
  const auto [first, second] = rotation_series<7, 1.0>::of(dot(axis, axis));
  return first * across + second * cross(across, axis);
}

}  // namespace polhode
