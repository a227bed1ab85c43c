// Dual numbers: a value and its derivative in N directions, over any scalar. Enough arithmetic for generators, which
// are polynomials in the state.
#pragma once

#include <polhode/vec.hpp>

namespace polhode {

template <class S, int N>
struct dual {
  S value{};
  vec<S, N> slope{};

  dual() = default;
  dual(double constant) : value(constant) {}  // NOLINT: a constant is a dual number
  dual(const S& v, const vec<S, N>& d) : value(v), slope(d) {}

  friend dual operator+(const dual& a, const dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend dual operator-(const dual& a, const dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend dual operator-(const dual& a) { return {-a.value, -a.slope}; }
  friend dual operator*(const dual& a, const dual& b) {
    return {a.value * b.value, a.value * b.slope + b.value * a.slope};
  }
};

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
