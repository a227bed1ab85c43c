// SPDX-License-Identifier: Apache-2.0
// su(n), n = 3 or 5, in the Fourier basis of the sine algebra, and its dual (Fairlie, Zachos, Phys. Lett. B 224
// (1989) 101-107). n is known at run time, by the size n^2 - 1 of a vector.
//
//   [xi, eta]_m = n / 2 pi sum_{k + l = m mod n} sin(2 pi (k x l) / n) xi_k eta_l,   k x l = k_1 l_2 - k_2 l_1
//   coad(xi, mu) = ad*_xi mu = [mu, xi],     exp_action(xi, mu) = exp(-X) M exp(X)
//
// X = i n / 4 pi H(xi) and [X, Y] = X Y - Y X; modes and the Hermitian matrix H of a vector are in lie/sine_basis.hpp.
// As n grows the bracket becomes that of Poisson, of functions on the torus.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <type_traits>

#include <polhode/dual.hpp>
#include <polhode/lie/bracket_series.hpp>
#include <polhode/lie/complex_matrix.hpp>
#include <polhode/lie/matrix_functions.hpp>
#include <polhode/lie/sine_basis.hpp>
#include <polhode/scalar.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct su : sine_basis {
  /// f(n) with the n of so many components known to the compiler.
  template <class F>
  static auto at_size(int components, F f) {
    return rows_of(components) == 3 ? f(std::integral_constant<int, 3>{}) : f(std::integral_constant<int, 5>{});
  }

  template <class S>
  POLHODE_CALLED static element<S> bracket(const element<S>& xi, const element<S>& eta) {
    if constexpr (is_dual<S>)
      return by_parts(xi, eta);
    else
      return at_size(xi.size, [&](auto n) { return bracket_of<n>(modes<n>(xi), modes<n>(eta)); });
  }
  template <class S>
  static element<S> coad(const element<S>& xi, const element<S>& mu) {
    return bracket(mu, xi);
  }
  template <class S>
  POLHODE_CALLED static element<S> exp_action(const element<S>& xi, const element<S>& mu) {
    return at_size(xi.size, [&](auto n) { return moved(exponential_less_one(generator_of<n>(xi)), mu); });
  }
  /// By the unitary matrix (1 - X/2)^-1 (1 + X/2); the Cayley transform of the coadjoint operator would keep |mu|
  /// alone.
  template <class S>
  POLHODE_CALLED static element<S> cayley_action(const element<S>& xi, const element<S>& mu) {
    return at_size(xi.size, [&](auto n) { return moved(cayley_less_one(generator_of<n>(xi)), mu); });
  }
  /// Right to rounding for |u| < 1/2.
  template <class S>
  POLHODE_CALLED static element<S> dexp_inv(const element<S>& u, const element<S>& v) {
    return dexp_inv_by_series<su>(u, v);
  }

  /// |mu|, then tr H^j / n, j = 3 … n, of H = sum mu_k J_k: they fix its eigenvalues.
  template <class S>
  static vec<S, 1 - most_rows> casimirs(const element<S>& mu) {
    const int n = rows_of(mu.size);
    const auto traces = traces_of(mu, n);
    vec<S, 1 - most_rows> out(n - 1);
    for (int j = 2; j <= n; ++j) out[j - 2] = traces[j];
    out[0] = square_root(out[0]);
    return out;
  }
  /// What a change of each is measured by: itself, or where j is odd, and it may be zero, the mean of its neighbours.
  template <class S>
  static vec<S, 1 - most_rows> casimir_sizes(const element<S>& mu) {
    const int n = rows_of(mu.size);
    const auto traces = traces_of(mu, n + 1);
    vec<S, 1 - most_rows> out(n - 1);
    for (int j = 2; j <= n; ++j) out[j - 2] = j % 2 == 0 ? traces[j] : square_root(S(traces[j - 1] * traces[j + 1]));
    out[0] = square_root(out[0]);
    return out;
  }

  /// A point of the orbit of `onto` next to mu: H + sum_k c_k H^k, k = 0 … n-1, its c_k by Newton's method. Where
  /// eigenvalues coincide |mu| alone is put right. Written as what is added to mu, as in so3.hpp.
  template <class S>
  POLHODE_CALLED static element<S> orbit_projection(const element<S>& mu, const element<S>& onto) {
    const S size = square_root(dot(onto, onto)), unit = S(1.0) / size;
    return at_size(mu.size, [&](auto n) {
      return mu + size * modes_of(towards(hermitian<n>(unit * mu), hermitian<n>(unit * onto),
                                          hermitian<n>(unit * (onto - mu))));
    });
  }

 private:
  /// The bracket is bilinear: that of dual numbers is made of brackets of their parts.
  template <class S, int N>
  static element<dual<S, N>> by_parts(const element<dual<S, N>>& xi, const element<dual<S, N>>& eta) {
    const auto part = [](const element<dual<S, N>>& a, int k) {
      element<S> out(a.size);
      for (int i = 0; i < a.size; ++i) out[i] = k < 0 ? a[i].value : a[i].slope[k];
      return out;
    };
    const auto x = part(xi, -1), y = part(eta, -1), value = bracket(x, y);
    element<dual<S, N>> out(xi.size);
    for (int i = 0; i < out.size; ++i) out[i].value = value[i];
    for (int k = 0; k < N; ++k) {
      const auto slope = bracket(part(xi, k), y) + bracket(x, part(eta, k));
      for (int i = 0; i < out.size; ++i) out[i].slope[k] = slope[i];
    }
    return out;
  }

  template <int n, class Modes, class S = decltype(Modes::value_type::real)>
  static element<S> bracket_of(const Modes& x, const Modes& y) {
    element<S> out(n * n - 1);
    for_each_mode_of<n>([&](auto index) {
      const auto sum = convolved<n, index>(x, y);
      out[2 * index] = sum.real;
      out[2 * index + 1] = sum.imaginary;
    });
    return out;
  }
  /// Of one mode m of the bracket sqrt(2) times the sum over k, first without the sines: those with k x m = j and, less
  /// them, with -j, j = 1 … n/2.
  template <int n, int index, class Modes, class number = typename Modes::value_type>
  static number convolved(const Modes& x, const Modes& y) {
    constexpr auto m = mode_of(index, n);
    std::array<number, n / 2> with;
#pragma GCC unroll 5
    for (int k1 = 0; k1 < n; ++k1)
#pragma GCC unroll 5
      for (int k2 = 0; k2 < n; ++k2) {
        const int angle = ((k1 * m.k2 - k2 * m.k1) % n + n) % n;
        if (angle == 0) continue;
        const auto& a = x[static_cast<std::size_t>(n * k1 + k2)];
        const auto& b = y[static_cast<std::size_t>(n * ((m.k1 - k1 + n) % n) + (m.k2 - k2 + 2 * n) % n)];
        auto& sum = with[static_cast<std::size_t>(std::min(angle, n - angle) - 1)];
        sum = plus_product(sum, a, angle <= n / 2 ? b : -b);
      }
    constexpr double unit = n / (2 * std::numbers::pi) * std::numbers::sqrt2;
    const auto& on = circle_of(n);
    number sum = times_constant(unit * on.at[1].imaginary, with[0]);
    for (std::size_t j = 2; j <= n / 2; ++j) sum = sum + times_constant(unit * on.at[j].imaginary, with[j - 1]);
    return sum;
  }

  /// i n / 4 pi H(xi).
  template <int n, class S>
  static complex_matrix<S, n> generator_of(const element<S>& xi) {
    auto x = hermitian<n>(S(n / (4 * std::numbers::pi)) * xi);
    for (auto& entry : x.entries) entry = {-entry.imaginary, entry.real};
    return x;
  }
  /// U^-1 H U, U = 1 + V.
  template <class S, int n>
  static element<S> moved(const complex_matrix<S, n>& v, const element<S>& mu) {
    return mu + modes_of(conjugation(v, hermitian<n>(mu)));
  }

  template <class S>
  using traces = vec<S, 1 - 2 * most_rows>;
  /// tr H^j / n, j = 0 … last.
  template <class S, int n>
  POLHODE_CALLED static traces<S> power_traces(const complex_matrix<S, n>& h, int last) {
    traces<S> out(last + 1);
    out[0] = S(1.0);
    auto power = h;
    for (int j = 2; j <= last; j += 2) {
      out[j] = S(1.0 / n) * power.square();
      if (j == last) break;
      const auto next = power * h;
      out[j + 1] = S(1.0 / n) * real_product(power, next);
      power = next;
    }
    return out;
  }
  template <class S>
  POLHODE_CALLED static traces<S> traces_of(const element<S>& mu, int last) {
    return at_size(mu.size, [&](auto n) { return power_traces(hermitian<n>(mu), last); });
  }
  /// The polynomial of h that, added to h, gives it the traces of a. apart = a - h.
  template <class S, int n>
  static complex_matrix<S, n> towards(complex_matrix<S, n> h, const complex_matrix<S, n>& a,
                                      complex_matrix<S, n> apart) {
    constexpr int corrections = 5;
    const auto one = complex_matrix<S, n>::identity(n);
    auto whole = S(0.0) * one;
    for (int i = 0; i < corrections; ++i) {
      const auto c = correction(power_traces(h, 2 * n - 2), trace_differences(h, a, apart), n);
      auto sum = c[n - 1] * h + c[n - 2] * one;
      for (int k = n - 3; k >= 0; --k) sum = sum * h + c[k] * one;
      h = h + sum;
      apart = apart - sum;
      whole = whole + sum;
    }
    return whole;
  }
  /// (tr A^j - tr H^j) / n, j = 1 … n, as tr (A - H) T_j / n, T_1 = 1, T_(j+1) = H T_j + A^j: the difference of two
  /// traces would be rounded like each of them, and the same way at every step.
  template <class S, int n>
  POLHODE_CALLED static vec<S, -most_rows> trace_differences(const complex_matrix<S, n>& h,
                                                             const complex_matrix<S, n>& a,
                                                             const complex_matrix<S, n>& apart) {
    auto out = zeros<vec<S, -most_rows>>(n);  // the first is zero
    auto power = a, t = h + a;
    for (int j = 2; j <= n; ++j) {
      out[j - 1] = S(1.0 / n) * real_product(apart, t);
      if (j == n) break;
      power = power * a;
      t = h * t + power;
    }
    return out;
  }
  /// Of the c_k: tr H^j / n is asked to change by d_j, and does so by j sum_k q_(j-1+k) c_k, q_j = tr H^j / n, j = 1 …
  /// n.
  template <class S>
  POLHODE_CALLED static vec<S, -most_rows> correction(const traces<S>& q, const vec<S, -most_rows>& asked, int n) {
    using numbers = vec<S, -most_rows>;
    auto slopes = zeros<polhode::matrix<S, -most_rows>>(n);
    auto missing = zeros<numbers>(n), scaling = missing;
    for (int j = 0; j < n; ++j) {
      slopes[j] = numbers(n);
      for (int k = 0; k < n; ++k) slopes[j][k] = q[j + k];
      missing[j] = S(1.0 / (j + 1)) * asked[j];
    }
    scaling[1] = missing[1] / q[2];
    const auto c = times(inverse(slopes), missing);
    S most(0.0);
    for (int k = 0; k < n; ++k) most = most + magnitude(c[k]);
    const auto regular = most < S(10.0);  // not where it is no number
    numbers out(n);
    for (int k = 0; k < n; ++k) out[k] = select(regular, c[k], scaling[k]);
    return out;
  }
};

}  // namespace polhode
