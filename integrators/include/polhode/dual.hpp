// SPDX-License-Identifier: Apache-2.0
// Dual numbers: a value and its derivative in N directions, over any scalar, a dual number included. A step that is
// called with them gives the next state and its tangents at once: the derivative of what is computed, not of the flow.
//
//   f(x + e dx) = f(x) + e f'(x) dx,   e^2 = 0
//
// Comparisons and selections look at the value alone.
#pragma once

#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

template <class S, int N>
struct dual {
  S value{};
  vec<S, N> slope{};

  dual() = default;
  dual(double constant) : value(S(constant)) {}  // NOLINT: a constant is a dual number
  dual(const S& v, const vec<S, N>& d) : value(v), slope(d) {}

  friend dual operator+(const dual& a, const dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend dual operator-(const dual& a, const dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend dual operator-(const dual& a) { return {-a.value, -a.slope}; }
  friend dual operator*(const dual& a, const dual& b) {
    return {a.value * b.value, a.value * b.slope + b.value * a.slope};
  }
  friend dual operator/(const dual& a, const dual& b) {
    const S quotient = a.value / b.value;
    return {quotient, (S(1.0) / b.value) * (a.slope - quotient * b.slope)};
  }

  friend auto operator==(const dual& a, const dual& b) { return a.value == b.value; }
  friend auto operator<(const dual& a, const dual& b) { return a.value < b.value; }
  friend auto operator>(const dual& a, const dual& b) { return a.value > b.value; }
  friend auto operator<=(const dual& a, const dual& b) { return a.value <= b.value; }
  friend auto operator>=(const dual& a, const dual& b) { return a.value >= b.value; }
};

template <class S>
inline constexpr bool is_dual = false;
template <class S, int N>
inline constexpr bool is_dual<dual<S, N>> = true;

template <class Mask, class S, int N>
dual<S, N> select(const Mask& condition, const dual<S, N>& yes, dual<S, N> no) {
  no.value = select(condition, yes.value, no.value);
  for (int k = 0; k < N; ++k) no.slope[k] = select(condition, yes.slope[k], no.slope[k]);
  return no;
}

template <class S, int N, class Mask>
bool any(const dual<S, N>& x, const Mask& mask) {
  return any(x.value, mask);
}

/// At 0 the slope is 0: right for the length of a vector that stays zero, and for whatever is even in a length.
template <class S, int N>
dual<S, N> square_root(const dual<S, N>& x) {
  const S root = square_root(x.value);
  const S factor = select(root == S(0.0), S(0.0), S(S(0.5) / root));
  return {root, factor * x.slope};
}

/// At 0 the slope is the argument's.
template <class S, int N>
dual<S, N> magnitude(const dual<S, N>& x) {
  return {magnitude(x.value), select(x.value < S(0.0), S(-1.0), S(1.0)) * x.slope};
}

template <class S, int N>
sine_cosine<dual<S, N>> sincos(const dual<S, N>& x) {
  const auto [sin, cos] = sincos(x.value);
  return {{sin, cos * x.slope}, {cos, S(-sin) * x.slope}};
}

template <class S, int N>
dual<S, N> exponential(const dual<S, N>& x) {
  const S value = exponential(x.value);
  return {value, value * x.slope};
}

/// The state mu with the unit directions as slopes: what f is called with to get f(mu) and its Jacobian.
template <class S, int N>
vec<dual<S, N>, N> seeded(const vec<S, N>& mu) {
  vec<dual<S, N>, N> x;
  for (int k = 0; k < N; ++k) {
    x[k].value = mu[k];
    x[k].slope[k] = S(1.0);
  }
  return x;
}

}  // namespace polhode
