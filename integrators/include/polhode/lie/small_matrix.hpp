// SPDX-License-Identifier: Apache-2.0
// Small square matrices over any scalar, their size known at run time alone.
#pragma once

#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// Row by row, at most `most` rows.
template <class S, int most>
struct small_matrix {
  using scalar = S;
  using entry = S;
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

  /// The sum of the squares of the entries.
  S square() const { return dot(entries, entries); }

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

}  // namespace polhode
