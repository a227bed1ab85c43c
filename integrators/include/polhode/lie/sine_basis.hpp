// SPDX-License-Identifier: Apache-2.0
// Fourier modes of real functions on the torus, n x n of them, as vectors and as Hermitian matrices.
//
// The modes are complex, v_{-k} = conj v_k, and k_1, k_2 go from -(n - 1)/2 to (n - 1)/2 without k = 0; n is 3 or 5. A
// vector has sqrt(2) Re v_k, sqrt(2) Im v_k for each k with k_1 > 0, or k_1 = 0 and k_2 > 0, in the order of k_1, then
// of k_2: its square is sum |v_k|^2 over all k. Its matrix is H(v) = sum_k v_k J_k, where J_k has the entries exp(2 pi
// i k_1 (a + b) / n) at b = a + k_2 mod n: tr H^2 = n |v|^2, J_k J_l = exp(-2 pi i (k x l) / n) J_{k+l}.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include <polhode/called.hpp>
#include <polhode/lie/complex_matrix.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct sine_basis {
  static constexpr int most_rows = 5, dimension = 1 - most_rows * most_rows;
  template <class S>
  using element = vec<S, dimension>;

  /// n of a vector of n^2 - 1 components.
  static constexpr int rows_of(int components) { return components < 24 ? 3 : 5; }

  /// f(place of the real part, k_1, k_2) for each mode of a vector.
  template <class F>
  static void for_each_mode(int n, F f) {
    const int most = n / 2;
    int place = 0;
    for (int k1 = 0; k1 <= most; ++k1)
      for (int k2 = k1 == 0 ? 1 : -most; k2 <= most; ++k2, place += 2) f(place, k1, k2);
  }

  /// The same, unrolled: f(integral constant of the index), of n^2 / 2 modes, whose numbers are mode_of<n>(index).
  template <int n, class F>
  static void for_each_mode_of(F f) {
    [&]<int... i>(std::integer_sequence<int, i...>) { (f(std::integral_constant<int, i>{}), ...); }
    (std::make_integer_sequence<int, n * n / 2>());
  }
  struct mode {
    int k1, k2;
  };
  static constexpr mode mode_of(int index, int n) {
    const int after_zero = index + n / 2 + 1;  // of the row k_1 = 0 the modes with k_2 > 0 alone
    return {after_zero / n, after_zero % n - n / 2};
  }

  /// k mod n, k from -n to n - 1.
  static constexpr int wrapped(int k, int n) { return k < 0 ? k + n : k; }

  /// exp(2 pi i j / n).
  struct circle {
    explicit circle(int n) {
      for (int j = 0; 2 * j < n; ++j) {
        at[j] = {std::cos(2 * std::numbers::pi * j / n), std::sin(2 * std::numbers::pi * j / n)};
        if (j > 0) at[n - j] = conjugate(at[j]);
      }
    }
    complex_number<double> at[most_rows];
  };
  static const circle& circle_of(int n) {
    static const std::array circles{circle(3), circle(5)};
    return circles[static_cast<std::size_t>(n / 2 - 1)];
  }

  /// All modes, of k_1 mod n and k_2 mod n, row by row; that of (0, 0) is zero.
  template <int n, class S>
  static std::array<complex_number<S>, static_cast<std::size_t>(n* n)> modes(const element<S>& v) {
    std::array<complex_number<S>, static_cast<std::size_t>(n * n)> out;
    const auto set = [&](int k1, int k2, const complex_number<S>& x) {
      out[static_cast<std::size_t>(n * wrapped(k1, n) + wrapped(k2, n))] = x;
    };
    for_each_mode(n, [&](int place, int k1, int k2) {
      const complex_number<S> x = S(1 / std::numbers::sqrt2) * complex_number<S>{v[place], v[place + 1]};
      set(k1, k2, x);
      set(-k1, -k2, conjugate(x));
    });
    return out;
  }
  /// H(v).
  template <int n, class S>
  POLHODE_CALLED static complex_matrix<S, n> hermitian(const element<S>& v) {
    const auto w = modes<n>(v);
    const auto& on = circle_of(n);
    complex_matrix<S, n> out;
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) {
        complex_number<S> sum;
        for (int k1 = 0; k1 < n; ++k1)
          sum = sum + times_constant(on.at[k1 * (a + b) % n], w[static_cast<std::size_t>(n * k1 + b - a)]);
        if (a == b) sum.imaginary = S(0.0);
        out(a, b) = sum;
        out(b, a) = conjugate(sum);
      }
    return out;
  }
  /// The inverse of `hermitian`; a multiple of 1 is dropped. It inverts what is computed with rounded roots of unity:
  /// one that did so but for their rounding would err by the same at every step, and let the Casimirs drift.
  template <class S, int n>
  static element<S> modes_of(const complex_matrix<S, n>& h) {
    const auto nearly = rounded_modes_of(h);
    return nearly + rounded_modes_of(h - hermitian<n>(nearly));
  }

 private:
  template <class S, int n>
  POLHODE_CALLED static element<S> rounded_modes_of(const complex_matrix<S, n>& h) {
    const auto& on = circle_of(n);
    element<S> out(n * n - 1);
    for_each_mode(n, [&](int place, int k1, int k2) {
      complex_number<S> sum;
      for (int a = 0; a < n; ++a) {
        const int b = (a + k2 + n) % n;
        sum = sum + times_constant(conjugate(on.at[k1 * (a + b) % n]), h(a, b));
      }
      out[place] = S(std::numbers::sqrt2 / n) * sum.real;
      out[place + 1] = S(std::numbers::sqrt2 / n) * sum.imaginary;
    });
    return out;
  }
};

}  // namespace polhode
