// SPDX-License-Identifier: Apache-2.0
// A skew matrix next to M, of 3 to 6 rows, whose eigenvalues are those of another one, T.
//
// It is M sum_k c_k P^k, P = M^T M, k < m = n/2. The eigenvalues are fixed by q_k = tr P^k / 2, k = 1 … m, and q_k
// changes by sum_j 2 k q_(k+j) dc_j: the c_k follow by Newton's method from (1, 0, …). Written as what is added to M,
// and the q_k as their differences, so that both round to their own size. With P_t = T^T T
//
//   tr P_t^k - P^k = tr (P_t - P) sum_j P_t^(k-1-j) P^j,   P_t - P = -(W (T + M) + (T + M) W) / 2,   W = T - M
//
// Where eigenvalues coincide |M| alone is put right. Powers of P commute and are symmetric, so that half of their
// entries are computed, and traces of their products are inner products.
#pragma once

#include <array>

#include <polhode/called.hpp>
#include <polhode/lie/fixed_matrix.hpp>
#include <polhode/scalar.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

namespace polhode {

namespace detail {

/// P^1 … P^m of a skew matrix.
template <int m, class S, int n>
std::array<fixed_matrix<S, n>, m> skew_powers(const fixed_matrix<S, n>& x) {
  std::array<fixed_matrix<S, n>, m> out;
  out[0] = S(-1.0) * self_adjoint_product(x, x);
  for (std::size_t k = 1; k < out.size(); ++k) out[k] = self_adjoint_product(out[k - 1], out[0]);
  return out;
}

template <class S, int n>
S trace(const fixed_matrix<S, n>& a) {
  S sum = a(0, 0);
  for (int i = 1; i < n; ++i) sum = sum + a(i, i);
  return sum;
}

/// q_1 … q_2m.
template <class S, int n, std::size_t m>
vec<S, 2 * static_cast<int>(m)> skew_traces(const std::array<fixed_matrix<S, n>, m>& powers) {
  vec<S, 2 * static_cast<int>(m)> out;
  out[0] = S(0.5) * trace(powers[0]);
  for (std::size_t k = 1; k < 2 * m; ++k)
    out[static_cast<int>(k)] = S(0.5) * inner_product(powers[k / 2], powers[(k - 1) / 2]);
  return out;
}

/// What q_1 … q_m change by from M to T.
template <class S, int n, std::size_t m>
vec<S, static_cast<int>(m)> trace_changes(const std::array<fixed_matrix<S, n>, m>& powers,
                                          const std::array<fixed_matrix<S, n>, m>& wanted,
                                          const fixed_matrix<S, n>& way, const fixed_matrix<S, n>& sum) {
  vec<S, static_cast<int>(m)> out;
  const auto half = way * sum;
  const auto change = S(-0.5) * (half + transposed(half));
  out[0] = S(0.5) * trace(change);
  if constexpr (m > 1) {
    auto between = powers[0] + wanted[0];
    out[1] = S(0.5) * inner_product(change, between);
    for (std::size_t k = 2; k < m; ++k) {
      between = between * powers[0] + wanted[k - 1];
      out[static_cast<int>(k)] = S(0.5) * inner_product(change, between);
    }
  }
  return out;
}

/// The dc_k, and how much of M they move.
template <class S, int m>
struct orbit_correction {
  vec<S, m> c;
  S size;
};
template <class S, int m>
orbit_correction<S, m> orbit_correction_of(const vec<S, 2 * m>& q, const vec<S, m>& change) {
  matrix<S, m> slopes;
  for (int k = 0; k < m; ++k)
    for (int j = 0; j < m; ++j) slopes[k][j] = S(2.0 * (k + 1)) * q[k + j];
  orbit_correction<S, m> out{times(inverse(slopes), change), S(0.0)};
  for (int k = 0; k < m; ++k) out.size = out.size + magnitude(out.c[k] * q[k]);
  out.size = out.size / q[0];
  const auto regular = out.size < S(10.0);  // not where it is no number
  const S scaling = change[0] / (S(2.0) * q[0]);
  for (int k = 0; k < m; ++k) out.c[k] = select(regular, out.c[k], k == 0 ? scaling : S(0.0));
  return out;
}

}  // namespace detail

/// What is added to x; way = onto - x, which may be known better than by that difference. A lane is done after a
/// correction whose square is far below rounding: the next one, with its derivative, would be none.
template <class S, int n>
POLHODE_CALLED fixed_matrix<S, n> skew_projection(const fixed_matrix<S, n>& x, const fixed_matrix<S, n>& onto,
                                                  const fixed_matrix<S, n>& way) {
  constexpr int m = n / 2, most_corrections = 6;
  constexpr double last = 1e-10;
  const auto wanted = detail::skew_powers<m>(onto);
  auto added = S(0.0) * x;
  auto pending = inner_product(x, x) >= S(0.0);  // not where it is no number
  for (int i = 0; i < most_corrections && any(S(0.0), pending); ++i) {
    const auto now = x + added;
    const auto powers = detail::skew_powers<m>(now);
    const auto by = detail::orbit_correction_of<S, m>(
        detail::skew_traces(powers), detail::trace_changes(powers, wanted, way + S(-1.0) * added, onto + now));
    fixed_matrix<S, n> factor;
    for (int row = 0; row < n; ++row)
      for (int k = 0; k < n; ++k) {
        factor(row, k) = row == k ? by.c[0] : S(0.0);
        for (int j = 1; j < m; ++j)
          factor(row, k) = factor(row, k) + by.c[j] * powers[static_cast<std::size_t>(j - 1)](row, k);
      }
    const auto change = skew_product(now, factor);
    for (std::size_t k = 0; k < added.entries.size(); ++k)
      added.entries[k] = select(pending, S(added.entries[k] + change.entries[k]), added.entries[k]);
    pending = pending && !(by.size <= S(last));
  }
  return added;
}

}  // namespace polhode
