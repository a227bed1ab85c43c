// SPDX-License-Identifier: Apache-2.0
// exp(X) - 1 of a skew matrix X of 3 to 6 rows, and what it does to another.
//
// The eigenvalues of Y = X^2 are -w_j^2, two of each, and 0 of odd n. By Cayley and Hamilton X chi(Y) = 0, chi(y) =
// prod_j (y + w_j^2) of degree m = n/2, so that the series of sine and cosine need m numbers each:
//
//   exp(X) - 1 = X sum_{j<m} s_j Y^j + Y sum_{j<m} c_j Y^j,
//   sum s_j y^j = sum_k y^k / (2k+1)!,   sum c_j y^j = sum_k y^k / (2k+2)!      modulo chi(y)
//
// The numbers are found by Horner's rule modulo chi, whose coefficients are tr Y, tr Y^2, tr Y^3 by Newton's
// identities. No eigenvalue is computed, so none may coincide. Source: Gallier, Xu, Int. J. Robotics Autom. 18 (2003)
// 10-20, have the closed forms.
#pragma once

#include <array>

#include <polhode/called.hpp>
#include <polhode/lie/fixed_matrix.hpp>
#include <polhode/scalar.hpp>

namespace polhode {

namespace detail {

template <class S, int m>
using chi_numbers = std::array<S, static_cast<std::size_t>(m)>;

/// sum_k y^k / (2k + first)!, k up to 13, modulo y^m + e_0 y^(m-1) + … + e_(m-1); for |y| <= 4 right to rounding.
template <int first, class S, std::size_t m>
std::array<S, m> reduced_series(const std::array<S, m>& e) {
  constexpr int terms = 13;
  constexpr auto factors = [] {
    std::array<double, terms + 1> out{};
    long double factor = 1;
    for (int k = 2; k <= first; ++k) factor /= k;
    for (int k = 0; k <= terms; ++k) {
      out[static_cast<std::size_t>(k)] = static_cast<double>(factor);
      factor /= (2 * k + first + 1) * (2 * k + first + 2);
    }
    return out;
  }();
  std::array<S, m> r{};
  r[0] = S(factors[terms]);
  for (std::size_t j = 1; j < m; ++j) r[j] = S(0.0);
  for (std::size_t k = terms; k-- > 0;) {
    const S top = r[m - 1];
    for (std::size_t j = m - 1; j > 0; --j) r[j] = r[j - 1] - top * e[m - 1 - j];
    r[0] = S(factors[k]) - top * e[m - 1];
  }
  return r;
}

/// The coefficients of chi from Y and, of m = 3, Y^2.
template <class S, int n, std::size_t m = n / 2>
std::array<S, m> chi_of(const fixed_matrix<S, n>& y, [[maybe_unused]] const fixed_matrix<S, n>& y2) {
  S trace = y(0, 0);
  for (int i = 1; i < n; ++i) trace = trace + y(i, i);
  std::array<S, m> e{};
  const S p1 = S(-0.5) * trace;
  e[0] = p1;
  if constexpr (m > 1) {
    const S p2 = S(0.5) * inner_product(y, y);
    e[1] = S(0.5) * (p1 * p1 - p2);
    if constexpr (m > 2) {
      const S p3 = S(-0.5) * inner_product(y, y2);
      e[2] = S(1.0 / 3) * (e[1] * p1 - e[0] * p2 + p3);
    }
  }
  return e;
}

/// sum_j a_j Y^j, j < m.
template <class S, int n, std::size_t m>
fixed_matrix<S, n> polynomial_of(const std::array<S, m>& a, const fixed_matrix<S, n>& y, const fixed_matrix<S, n>& y2) {
  fixed_matrix<S, n> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      S sum = i == j ? a[0] : S(0.0);
      if constexpr (m > 1) sum = sum + a[1] * y(i, j);
      if constexpr (m > 2) sum = sum + a[2] * y2(i, j);
      out(i, j) = sum;
    }
  return out;
}

}  // namespace detail

/// Larger ones by halvings and squarings; how many is a lane's own.
template <class S, int n>
POLHODE_CALLED fixed_matrix<S, n> skew_exponential_less_one(fixed_matrix<S, n> x) {
  constexpr int most_halvings = 60;
  constexpr double largest = 8;  // of |X|^2 >= 2 max w_j^2
  S square = inner_product(x, x), scale(1.0), halvings(0.0);
  const bool far = any(square, square > S(largest));
  for (int i = 0; i < most_halvings && far; ++i) {
    const auto large = square > S(largest);
    scale = select(large, S(S(0.5) * scale), scale);
    halvings = select(large, S(halvings + S(1.0)), halvings);
    square = select(large, S(S(0.25) * square), square);
  }
  if (far) x = scale * x;

  const auto y = self_adjoint_product(x, x);
  const auto y2 = [&] {  // which three rows do not need
    if constexpr (n > 3)
      return self_adjoint_product(y, y);
    else
      return y;
  }();
  const auto e = detail::chi_of(y, y2);
  const auto sine = detail::reduced_series<1>(e), cosine = detail::reduced_series<2>(e);
  auto out = skew_product(x, detail::polynomial_of(sine, y, y2));
  if constexpr (n < 6) {
    for (std::size_t k = 0; k < out.entries.size(); ++k) {
      out.entries[k] = out.entries[k] + cosine[0] * y.entries[k];
      if constexpr (n > 3) out.entries[k] = out.entries[k] + cosine[1] * y2.entries[k];
    }
  } else {
    out = out + self_adjoint_product(y, detail::polynomial_of(cosine, y, y2));
  }

  for (int i = 0; i < most_halvings && far; ++i) {
    const auto pending = halvings > S(0.5);
    if (!any(halvings, pending)) break;
    const auto squared = S(2.0) * out + out * out;
    for (std::size_t k = 0; k < out.entries.size(); ++k)
      out.entries[k] = select(pending, squared.entries[k], out.entries[k]);
    halvings = halvings - S(1.0);
  }
  return out;
}

/// U^T M U - M of U = 1 + V, which is orthogonal but for rounding, and skew M. A step of Newton's method, U (3 - U^T U)
/// / 2, leaves rounding of the next order: what V brings would let the Casimirs drift.
template <class S, int n>
POLHODE_CALLED fixed_matrix<S, n> skew_conjugation(const fixed_matrix<S, n>& v, const fixed_matrix<S, n>& m) {
  auto excess = self_adjoint_product(transposed(v), v);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) excess(i, j) = excess(i, j) + (v(i, j) + v(j, i));
  const auto better = v + S(-0.5) * (excess + v * excess);
  // V^T M V + M V + V^T M, the last two the skew part of 2 M V.
  const auto half = m * better;
  auto out = skew_product(transposed(better), half);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out(i, j) = out(i, j) + (half(i, j) - half(j, i));
  return out;
}

}  // namespace polhode
