// Small dense linear systems over any scalar.
#pragma once

#include <utility>

#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// Solves A x = b; rows[i] is row i of A. Gaussian elimination with partial pivoting, lane by lane. A singular matrix
/// gives non-finite numbers in its own lane.
template <class S, int N>
vec<S, N> solve(vec<vec<S, N>, N> rows, vec<S, N> b) {
  for (int k = 0; k < N; ++k) {
    for (int i = k + 1; i < N; ++i) {
      const auto larger = magnitude(rows[i][k]) > magnitude(rows[k][k]);
      for (int j = k; j < N; ++j) {
        const S upper = select(larger, rows[i][j], rows[k][j]), lower = select(larger, rows[k][j], rows[i][j]);
        rows[k][j] = upper;
        rows[i][j] = lower;
      }
      const S upper = select(larger, b[i], b[k]), lower = select(larger, b[k], b[i]);
      b[k] = upper;
      b[i] = lower;
    }
    for (int i = k + 1; i < N; ++i) {
      const S factor = rows[i][k] / rows[k][k];
      for (int j = k + 1; j < N; ++j) rows[i][j] = rows[i][j] - factor * rows[k][j];
      b[i] = b[i] - factor * b[k];
    }
  }
  for (int k = N - 1; k >= 0; --k) {
    for (int j = k + 1; j < N; ++j) b[k] = b[k] - rows[k][j] * b[j];
    b[k] = b[k] / rows[k][k];
  }
  return b;
}

}  // namespace polhode
