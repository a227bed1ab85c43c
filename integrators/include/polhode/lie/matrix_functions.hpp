// SPDX-License-Identifier: Apache-2.0
// Exponentials and Cayley transforms of small square matrices, real (fixed_matrix.hpp) or complex (complex_matrix.hpp).
#pragma once

#include <polhode/called.hpp>
#include <polhode/scalar.hpp>

namespace polhode {

/// Of a real entry; complex_matrix.hpp has those of a complex one.
template <class S>
S reciprocal(const S& x) {
  return S(1.0) / x;
}
template <class S>
const S& conjugate(const S& x) {
  return x;
}

// What acts on a state is U - 1: its rounding is relative to the size of a step, not of 1.

/// exp(x) - 1 of a skew-Hermitian x, by a Taylor polynomial of degree 12 of x / 2^s and s squarings; s is a lane's own.
template <class matrix>
POLHODE_CALLED matrix exponential_less_one(matrix x) {
  using S = typename matrix::scalar;
  constexpr int most_halvings = 60;
  constexpr double largest = 1.0 / 16;  // of |x / 2^s|^2: the next term is below rounding
  S square = x.square(), scale(1.0), halvings(0.0);
  for (int i = 0; i < most_halvings && any(S(0.0), square > S(largest)); ++i) {
    const auto large = square > S(largest);
    scale = select(large, S(S(0.5) * scale), scale);
    halvings = select(large, S(halvings + S(1.0)), halvings);
    square = select(large, S(S(0.25) * square), square);
  }
  x = scale * x;
  // sum of x^k / k!, four terms at a time: rest + a + b x + c x^2 + d x^3, entry by entry.
  const matrix x2 = self_adjoint_product(x, x), x3 = skew_product(x2, x), x4 = self_adjoint_product(x2, x2);
  const auto plus_terms = [&](matrix rest, double a, double b, double c, double d) {
    for (int row = 0; row < x.n; ++row) {
      for (int k = 0; k < x.n; ++k)
        rest(row, k) = rest(row, k) + S(b) * x(row, k) + S(c) * x2(row, k) + S(d) * x3(row, k);
      rest(row, row) = rest(row, row) + typename matrix::entry{S(a)};
    }
    return rest;
  };
  matrix out = plus_terms(S(1.0 / 479001600) * x4, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800);
  out = plus_terms(x4 * out, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040);
  out = plus_terms(x4 * out, 0, 1, 0.5, 1.0 / 6);
  for (int i = 0; i < most_halvings && any(S(0.0), halvings > S(0.5)); ++i) {
    const auto pending = halvings > S(0.5);
    const matrix squared = S(2.0) * out + out * out;
    for (int row = 0; row < x.n; ++row)
      for (int k = 0; k < x.n; ++k) out(row, k) = select(pending, squared(row, k), out(row, k));
    halvings = halvings - S(1.0);
  }
  return out;
}

/// (1 - x/2)^-1 (1 + x/2) - 1 = (1 - x/2)^-1 x, by elimination without pivots, which a positive symmetric part of
/// 1 - x/2 allows.
template <class matrix>
POLHODE_CALLED matrix cayley_less_one(const matrix& x) {
  using S = typename matrix::scalar;
  using entry = typename matrix::entry;
  matrix a = matrix::identity(x.n) + S(-0.5) * x, out = x;
  for (int k = 0; k < x.n; ++k) {
    const entry pivot = reciprocal(a(k, k));
    for (int j = 0; j < x.n; ++j) {
      a(k, j) = pivot * a(k, j);
      out(k, j) = pivot * out(k, j);
    }
    for (int i = 0; i < x.n; ++i) {
      if (i == k) continue;
      const entry factor = a(i, k);
      for (int j = 0; j < x.n; ++j) {
        a(i, j) = a(i, j) - factor * a(k, j);
        out(i, j) = out(i, j) - factor * out(k, j);
      }
    }
  }
  return out;
}

/// U* M U - M of U = 1 + V, which is unitary but for rounding, and a Hermitian M. A step of Newton's method,
/// U (3 - U* U) / 2, leaves rounding of the next order: what squarings leave would let the Casimirs drift.
template <class matrix>
POLHODE_CALLED matrix conjugation(const matrix& v, const matrix& m) {
  using S = typename matrix::scalar;
  const matrix back = adjoint(v), excess = v + back + self_adjoint_product(back, v);
  const matrix better = v + S(-0.5) * (excess + v * excess);
  const matrix half = m * better;
  return half + adjoint(half) + self_adjoint_product(adjoint(better), half);
}

}  // namespace polhode
