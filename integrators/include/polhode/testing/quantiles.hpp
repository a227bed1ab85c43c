// SPDX-License-Identifier: Apache-2.0
// Normal and Student deviates from the standard library alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace polhode::testkit {

/// P(X > x), X standard normal.
inline double normal_tail(double x) { return std::erfc(x / std::numbers::sqrt2) / 2; }

/// x with P(X > x) = tail, 1e-300 <= tail < 1. Newton's iteration for log P, which is concave: from P(X > x) <=
/// exp(-x^2/2)/2 it begins above the root and falls to it.
inline double normal_deviate(double tail) {
  if (tail > 0.5) return -normal_deviate(1 - tail);
  double x = std::sqrt(-2 * std::log(2 * tail));
  for (int i = 0; i < 60; ++i) {
    const double p = normal_tail(x), density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
    const double step = std::log(p / tail) * p / density;
    x += step;
    if (std::fabs(step) < 1e-15 * (1 + x)) break;
  }
  return x;
}

/// The incomplete beta function I_x(a, b) by its continued fraction (DLMF 8.17.22, modified Lentz), for
/// x < (a + 1) / (a + b + 2). one_less: 1 - x, given apart so that it is not lost to rounding.
inline double incomplete_beta(double x, double one_less, double a, double b) {
  const double front =
      std::exp(a * std::log(x) + b * std::log(one_less) + std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b)) / a;
  constexpr double tiny = 1e-300;
  const auto away = [](double v) { return std::fabs(v) < tiny ? tiny : v; };
  double c = 1, d = 1 / away(1 - (a + b) * x / (a + 1)), fraction = d;
  for (int m = 1; m < 20000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / away(1 + even * d);
    c = away(1 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / away(1 + odd * d);
    c = away(1 + odd / c);
    fraction *= d * c;
    if (std::fabs(d * c - 1) < 1e-15) break;
  }
  return front * fraction;
}

/// P(T > t), t >= 0, T with Student's law of `degrees` > 0 degrees of freedom (DLMF 8.17.2; Abramowitz, Stegun 26.7.1).
inline double student_tail(double t, double degrees) {
  const double a = degrees / 2, whole = degrees + t * t, x = degrees / whole, rest = t * t / whole;
  return x < (a + 1) / (a + 2.5) ? incomplete_beta(x, rest, a, 0.5) / 2 : 0.5 - incomplete_beta(rest, x, 0.5, a) / 2;
}

/// t with P(T > t) = tail, 0 < tail < 1/2, to 1e-8 of it up to a million degrees: Newton's iteration for log P in log
/// t, held in a bracket. Begins at Fisher and Cornish's expansion (Abramowitz, Stegun 26.7.5).
inline double student_deviate(double tail, double degrees) {
  const double z = normal_deviate(tail), z2 = z * z, n = degrees;
  const double density_at_0 = std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2)) / std::sqrt(n * std::numbers::pi);
  double low = z, high = std::max(2 * z, 1.0);
  while (student_tail(high, n) > tail) low = std::exchange(high, 4 * high);
  double t = z + z * (z2 + 1) / (4 * n) + z * ((5 * z2 + 16) * z2 + 3) / (96 * n * n);
  for (int i = 0; i < 100; ++i) {
    if (!(t > low && t < high)) t = (low + high) / 2;
    const double p = student_tail(t, n);
    (p > tail ? low : high) = t;
    const double density = density_at_0 * std::exp(-(n + 1) / 2 * std::log1p(t * t / n));
    const double next = t * std::exp(std::log(p / tail) * p / (density * t));
    if (std::fabs(next - t) < 1e-13 * t) return next;
    t = next;
  }
  return t;
}

}  // namespace polhode::testkit
