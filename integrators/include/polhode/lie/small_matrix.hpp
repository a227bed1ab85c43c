// Small square matrices over any scalar, their size known at run time alone: products, exponentials, inverses.
#pragma once

#include <polhode/scalar.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// Row by row, at most `most` rows.
template <class S, int most>
struct small_matrix {
  explicit small_matrix(int rows) : n(rows), entries(rows * rows) {}
  static small_matrix identity(int rows) {
    small_matrix out(rows);
    for (int i = 0; i < rows; ++i) out(i, i) = S(1.0);
    return out;
  }

  int n;
  vec<S, -most * most> entries;
  S& operator()(int i, int j) { return entries[n * i + j]; }
  const S& operator()(int i, int j) const { return entries[n * i + j]; }

  friend small_matrix operator+(small_matrix a, const small_matrix& b) {
    a.entries = a.entries + b.entries;
    return a;
  }
  friend small_matrix operator*(const S& s, small_matrix a) {
    a.entries = s * a.entries;
    return a;
  }
  [[gnu::noinline]] friend small_matrix operator*(const small_matrix& a, const small_matrix& b) {
    small_matrix out(a.n);
    for (int i = 0; i < a.n; ++i)
      for (int j = 0; j < a.n; ++j) {
        S sum = a(i, 0) * b(0, j);
        for (int k = 1; k < a.n; ++k) sum = sum + a(i, k) * b(k, j);
        out(i, j) = sum;
      }
    return out;
  }
};

/// exp(x), by a Taylor polynomial of degree 12 of x / 2^s and s squarings; s is a lane's own.
template <class S, int most>
[[gnu::noinline]] small_matrix<S, most> exponential_of(small_matrix<S, most> x) {
  using matrix = small_matrix<S, most>;
  constexpr int most_halvings = 60;
  constexpr double largest = 1.0 / 16;  // of |x / 2^s|^2: the next term is below rounding
  S square = dot(x.entries, x.entries), scale(1.0), halvings(0.0);
  for (int i = 0; i < most_halvings && any(S(0.0), square > S(largest)); ++i) {
    const auto large = square > S(largest);
    scale = select(large, S(S(0.5) * scale), scale);
    halvings = select(large, S(halvings + S(1.0)), halvings);
    square = select(large, S(S(0.25) * square), square);
  }
  x = scale * x;
  // sum of x^k / k!, four terms at a time.
  const matrix one = matrix::identity(x.n), x2 = x * x, x3 = x2 * x, x4 = x2 * x2;
  const auto block = [&](double a, double b, double c, double d) {
    return S(a) * one + S(b) * x + S(c) * x2 + S(d) * x3;
  };
  matrix out = block(1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800) + S(1.0 / 479001600) * x4;
  out = block(1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040) + x4 * out;
  out = block(1, 1, 0.5, 1.0 / 6) + x4 * out;
  for (int i = 0; i < most_halvings && any(S(0.0), halvings > S(0.5)); ++i) {
    const auto pending = halvings > S(0.5);
    const matrix squared = out * out;
    for (int k = 0; k < out.entries.size; ++k) out.entries[k] = select(pending, squared.entries[k], out.entries[k]);
    halvings = halvings - S(1.0);
  }
  return out;
}

/// (1 - x/2)^-1 (1 + x/2), by elimination without pivots, which a positive symmetric part of 1 - x/2 allows.
template <class S, int most>
[[gnu::noinline]] small_matrix<S, most> cayley_of(const small_matrix<S, most>& x) {
  using matrix = small_matrix<S, most>;
  matrix a = matrix::identity(x.n) + S(-0.5) * x, out = matrix::identity(x.n) + S(0.5) * x;
  for (int k = 0; k < x.n; ++k) {
    const S pivot = S(1.0) / a(k, k);
    for (int j = 0; j < x.n; ++j) {
      a(k, j) = pivot * a(k, j);
      out(k, j) = pivot * out(k, j);
    }
    for (int i = 0; i < x.n; ++i) {
      if (i == k) continue;
      const S factor = a(i, k);
      for (int j = 0; j < x.n; ++j) {
        a(i, j) = a(i, j) - factor * a(k, j);
        out(i, j) = out(i, j) - factor * out(k, j);
      }
    }
  }
  return out;
}

/// A matrix that is orthogonal but for rounding, to rounding of the next order: a step of Newton's method, R (3 - R^T
/// R) / 2. What squarings leave would let the Casimirs drift.
template <class S, int most>
[[gnu::noinline]] small_matrix<S, most> orthogonal(const small_matrix<S, most>& nearly) {
  auto excess = small_matrix<S, most>::identity(nearly.n);
  for (int i = 0; i < nearly.n; ++i)
    for (int j = 0; j < nearly.n; ++j)
      for (int k = 0; k < nearly.n; ++k) excess(i, j) = excess(i, j) - nearly(k, i) * nearly(k, j);
  return nearly + S(0.5) * (nearly * excess);
}

}  // namespace polhode
