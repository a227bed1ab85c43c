// SPDX-License-Identifier: Apache-2.0
// Near-best polynomials on [0, bound], for a bound that may be known at compile time: what rotations by small angles
// and normalisations of almost normal vectors are evaluated with.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

namespace polhode {

/// Coefficients, lowest first, of a polynomial.
template <int degree>
using polynomial = std::array<double, static_cast<std::size_t>(degree) + 1>;

namespace detail {

/// sum_k (-q)^k / (2k + first)!: cos sqrt(q) for first = 0, sinc sqrt(q) for 1, (1 - cos sqrt(q))/q for 2,
/// (1 - sinc sqrt(q))/q for 3. q of order 1.
constexpr long double cosine_series(long double q, int first) {
  long double term = first == 3 ? 1 / 6.0L : first == 2 ? 0.5L : 1, sum = 0;
  for (int k = 0; k < 24; ++k) {
    sum += term;
    term *= -q / ((2 * k + first + 1) * (2 * k + first + 2));
  }
  return sum;
}

}  // namespace detail

/// The interpolation of f at the Chebyshev points of [0, bound], in powers of its argument.
template <int degree, class F>
constexpr polynomial<degree> chebyshev_interpolation(F f, long double bound) {
  constexpr std::size_t n = degree + 1;
  std::array<long double, n> at{}, value{}, sum{};
  for (std::size_t i = 0; i < n; ++i) {
    const long double angle = std::numbers::pi_v<long double> * static_cast<long double>(2 * i + 1) / (4 * n);
    const long double c = detail::cosine_series(angle * angle, 0);
    at[i] = bound * c * c;  // bound/2 (1 + cos 2 angle)
    value[i] = f(at[i]);
  }
  for (std::size_t k = 1; k < n; ++k)  // Newton's divided differences
    for (std::size_t i = n; i-- > k;) value[i] = (value[i] - value[i - 1]) / (at[i] - at[i - k]);
  for (std::size_t i = n; i-- > 0;) {  // sum = sum (q - at_i) + value_i
    for (std::size_t k = n - 1; k > 0; --k) sum[k] = sum[k - 1] - at[i] * sum[k];
    sum[0] = value[i] - at[i] * sum[0];
  }
  polynomial<degree> out{};
  for (std::size_t k = 0; k < n; ++k) out[k] = static_cast<double>(sum[k]);
  return out;
}

/// Of cosine_series(., first). The error is at most 2 (bound/4)^(degree + 1) / (2 degree + 2 + first)! (1 + small), the
/// remainder of the interpolation formula.
template <int degree>
constexpr polynomial<degree> cosine_polynomial(int first, double bound) {
  return chebyshev_interpolation<degree>([first](long double q) { return detail::cosine_series(q, first); }, bound);
}

/// Horner's rule.
template <class S, std::size_t n>
S evaluate(const std::array<double, n>& p, const S& q) {
  S sum = S(p[n - 1]);
  for (std::size_t k = n - 1; k-- > 0;) sum = sum * q + S(p[k]);
  return sum;
}

}  // namespace polhode
