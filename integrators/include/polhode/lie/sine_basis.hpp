// Fourier modes of real functions on the torus, n x n of them, as vectors and as Hermitian matrices.
//
// The modes are complex, v_{-k} = conj v_k, and k_1, k_2 go from -(n - 1)/2 to (n - 1)/2 without k = 0; n is odd. A
// vector has sqrt(2) Re v_k, sqrt(2) Im v_k for each k with k_1 > 0, or k_1 = 0 and k_2 > 0, in the order of k_1, then
// of k_2: its square is sum |v_k|^2 over all k. Its matrix is H(v) = sum_k v_k J_k, where J_k has the entries exp(2 pi
// i k_1 (a + b) / n) at b = a + k_2 mod n: tr H^2 = n |v|^2, J_k J_l = exp(-2 pi i (k x l) / n) J_{k+l}.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <polhode/lie/small_matrix.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct sine_basis {
  static constexpr int most_rows = 7, dimension = 1 - most_rows * most_rows;
  template <class S>
  using element = vec<S, dimension>;
  /// A + i B as the real matrix (A, -B; B, A), symmetric of a Hermitian one.
  template <class S>
  using matrix = small_matrix<S, 2 * most_rows>;

  /// n of a vector of n^2 - 1 components.
  static constexpr int rows_of(int components) { return components < 24 ? 3 : components < 48 ? 5 : 7; }

  /// f(place of the real part, k_1, k_2) for each mode of a vector.
  template <class F>
  static void for_each_mode(int n, F f) {
    const int most = n / 2;
    int place = 0;
    for (int k1 = 0; k1 <= most; ++k1)
      for (int k2 = k1 == 0 ? 1 : -most; k2 <= most; ++k2, place += 2) f(place, k1, k2);
  }

 protected:
  /// k mod n, k from -n to n - 1.
  static int wrapped(int k, int n) { return k < 0 ? k + n : k; }

  /// sin and cos of 2 pi j / n.
  struct circle {
    explicit circle(int n) {
      for (int j = 0; 2 * j < n; ++j) {
        sin[j] = std::sin(2 * std::numbers::pi * j / n);
        cos[j] = std::cos(2 * std::numbers::pi * j / n);
        if (j > 0) sin[n - j] = -sin[j], cos[n - j] = cos[j];
      }
    }
    double sin[most_rows] = {}, cos[most_rows] = {};
  };
  static const circle& circle_of(int n) {
    static const std::array circles{circle(3), circle(5), circle(7)};
    return circles[static_cast<std::size_t>(n / 2 - 1)];
  }

  /// All modes, of k_1 mod n and k_2 mod n.
  template <class S>
  struct modes {
    explicit modes(const element<S>& v) : real(rows_of(v.size)), imaginary(real.n) {
      const int n = real.n;
      for_each_mode(n, [&](int place, int k1, int k2) {
        const S a = S(1 / std::numbers::sqrt2) * v[place], b = S(1 / std::numbers::sqrt2) * v[place + 1];
        real(k1, wrapped(k2, n)) = real(wrapped(-k1, n), wrapped(-k2, n)) = a;
        imaginary(k1, wrapped(k2, n)) = b;
        imaginary(wrapped(-k1, n), wrapped(-k2, n)) = -b;
      });
    }
    small_matrix<S, most_rows> real, imaginary;
  };

  /// H(v).
  template <class S>
  static matrix<S> hermitian(const element<S>& v) {
    const modes<S> w(v);
    const int n = w.real.n;
    const auto& at = circle_of(n);
    matrix<S> out(2 * n);
    for (int a = 0; a < n; ++a)
      for (int b = a; b < n; ++b) {
        S real(0.0), imaginary(0.0);
        const int step = wrapped(a + b - n, n) - n;
        for (int k1 = 0, angle = 0; k1 < n; ++k1, angle = wrapped(angle + step, n)) {
          const S cos(at.cos[angle]), sin(at.sin[angle]);
          real = real + (cos * w.real(k1, b - a) - sin * w.imaginary(k1, b - a));
          imaginary = imaginary + (cos * w.imaginary(k1, b - a) + sin * w.real(k1, b - a));
        }
        set_entry(out, a, b, real, a == b ? S(0.0) : imaginary);
        if (a != b) set_entry(out, b, a, real, S(-imaginary));
      }
    return out;
  }
  /// i n / 4 pi H(xi).
  template <class S>
  static matrix<S> generator_of(const element<S>& xi) {
    const auto h = hermitian(S(rows_of(xi.size) / (4 * std::numbers::pi)) * xi);
    const int n = h.n / 2;
    matrix<S> out(h.n);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) set_entry(out, a, b, S(-h(n + a, b)), h(a, b));
    return out;
  }
  /// The inverse of `hermitian`; a multiple of 1 is dropped.
  template <class S>
  static element<S> modes_of(const matrix<S>& h) {
    const int n = h.n / 2;
    const auto& at = circle_of(n);
    element<S> out(n * n - 1);
    for_each_mode(n, [&](int place, int k1, int k2) {
      S real(0.0), imaginary(0.0);
      for (int a = 0; a < n; ++a) {
        const int b = wrapped(a + wrapped(k2, n) - n, n), angle = k1 * (a + b) % n;
        const S cos(at.cos[angle]), sin(at.sin[angle]);
        real = real + (cos * h(a, b) + sin * h(n + a, b));
        imaginary = imaginary + (cos * h(n + a, b) - sin * h(a, b));
      }
      out[place] = S(std::numbers::sqrt2 / n) * real;
      out[place + 1] = S(std::numbers::sqrt2 / n) * imaginary;
    });
    return out;
  }

 private:
  /// (A, -B; B, A).
  template <class S>
  static void set_entry(matrix<S>& m, int a, int b, const S& real, const S& imaginary) {
    const int n = m.n / 2;
    m(a, b) = m(n + a, n + b) = real;
    m(n + a, b) = imaginary;
    m(a, n + b) = -imaginary;
  }
};

}  // namespace polhode
