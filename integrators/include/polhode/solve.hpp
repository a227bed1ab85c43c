// SPDX-License-Identifier: Apache-2.0
// Small dense matrices over any scalar.
#pragma once

#include <utility>

#include <polhode/scalar.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// Component by component: yes where the condition holds, no elsewhere.
template <class Mask, class S, int N>
vec<S, N> select(const Mask& condition, const vec<S, N>& yes, vec<S, N> no) {
  for (int k = 0; k < no.size; ++k) no[k] = select(condition, yes[k], no[k]);
  return no;
}

/// rows[i] is row i.
template <class S, int N>
using matrix = vec<vec<S, N>, N>;

template <class S, int N>
vec<S, N> times(const matrix<S, N>& rows, const vec<S, N>& x) {
  auto out = zeros<vec<S, N>>(x.size);
  for (int i = 0; i < x.size; ++i) out[i] = dot(rows[i], x);
  return out;
}

/// Where the division for 1 / det A goes: `truncated`, 2 - det A in its place, gives A^-1 but for a factor
/// 1 - (det A - 1)^2, which does for a preconditioner of an A near the identity.
enum class quotient { exact, truncated };

/// A^-1 by cofactors. A singular matrix gives non-finite numbers in its own lane.
template <quotient q = quotient::exact, class S>
matrix<S, 3> inverse(const matrix<S, 3>& a) {
  const auto x = cross(a[1], a[2]), y = cross(a[2], a[0]), z = cross(a[0], a[1]);
  const S det = dot(a[0], x), scale = q == quotient::exact ? S(1.0) / det : S(2.0) - det;
  matrix<S, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = scale * vec<S, 3>{{x[i], y[i], z[i]}};
  return out;
}

/// A^-1 by Gauss and Jordan's elimination with partial pivoting, lane by lane. A singular matrix gives non-finite
/// numbers in its own lane.
template <quotient = quotient::exact, class S, int N>
matrix<S, N> inverse(matrix<S, N> a) {
  const int n = a.size;
  auto out = zeros<matrix<S, N>>(n);
  for (int i = 0; i < n; ++i) {
    out[i] = zeros<vec<S, N>>(n);
    out[i][i] = S(1.0);
  }
  for (int k = 0; k < n; ++k) {
    for (int i = k + 1; i < n; ++i) {
      const auto larger = magnitude(a[i][k]) > magnitude(a[k][k]);
      const auto ordered = [&](matrix<S, N>& m, int j) {
        const S upper = select(larger, m[i][j], m[k][j]), lower = select(larger, m[k][j], m[i][j]);
        m[k][j] = upper;
        m[i][j] = lower;
      };
      for (int j = 0; j < n; ++j) {
        ordered(a, j);
        ordered(out, j);
      }
    }
    const S pivot = S(1.0) / a[k][k];
    a[k] = pivot * a[k];
    out[k] = pivot * out[k];
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const S factor = a[i][k];
      a[i] = a[i] - factor * a[k];
      out[i] = out[i] - factor * out[k];
    }
  }
  return out;
}

}  // namespace polhode
