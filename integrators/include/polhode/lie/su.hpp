// su(n), n = 3, 5 or 7, in the Fourier basis of the sine algebra, and its dual (Fairlie, Zachos, Phys. Lett. B 224
// (1989) 101-107). n is known at run time, by the size n^2 - 1 of a vector.
//
//   [xi, eta]_m = n / 2 pi sum_{k + l = m mod n} sin(2 pi (k x l) / n) xi_k eta_l,   k x l = k_1 l_2 - k_2 l_1
//   coad(xi, mu) = ad*_xi mu = [mu, xi],     exp_action(xi, mu) = exp(-X) M exp(X)
//
// X = i n / 4 pi H(xi) and [X, Y] = X Y - Y X; modes and the Hermitian matrix H of a vector are in lie/sine_basis.hpp.
// As n grows the bracket becomes that of Poisson, of functions on the torus.
#pragma once

#include <numbers>

#include <polhode/lie/bracket_series.hpp>
#include <polhode/lie/sine_basis.hpp>
#include <polhode/lie/small_matrix.hpp>
#include <polhode/scalar.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct su : sine_basis {
  template <class S>
  [[gnu::noinline]] static element<S> bracket(const element<S>& xi, const element<S>& eta) {
    const int n = rows_of(xi.size);
    const auto& at = circle_of(n);
    const modes<S> x(xi), y(eta);
    element<S> out(xi.size);
    const S unit(n / (2 * std::numbers::pi) * std::numbers::sqrt2);
    for_each_mode(n, [&](int place, int m1, int m2) {
      m2 = wrapped(m2, n);
      S real(0.0), imaginary(0.0);
      for (int k1 = 0, first = 0; k1 < n; ++k1, first = wrapped(first + m2 - n, n))
        for (int k2 = 0, angle = first; k2 < n; ++k2, angle = wrapped(angle - m1, n)) {  // k x m mod n
          if (angle == 0) continue;
          const int l1 = wrapped(m1 - k1, n), l2 = wrapped(m2 - k2, n);
          const S sine(at.sin[angle]), a = sine * x.real(k1, k2), b = sine * x.imaginary(k1, k2);
          real = real + (a * y.real(l1, l2) - b * y.imaginary(l1, l2));
          imaginary = imaginary + (a * y.imaginary(l1, l2) + b * y.real(l1, l2));
        }
      out[place] = unit * real;
      out[place + 1] = unit * imaginary;
    });
    return out;
  }
  template <class S>
  static element<S> coad(const element<S>& xi, const element<S>& mu) {
    return bracket(mu, xi);
  }
  template <class S>
  [[gnu::noinline]] static element<S> exp_action(const element<S>& xi, const element<S>& mu) {
    return turned(exponential_of(generator_of(xi)), mu);
  }
  /// By the unitary matrix (1 - X/2)^-1 (1 + X/2); the Cayley transform of the coadjoint operator would keep |mu|
  /// alone.
  template <class S>
  [[gnu::noinline]] static element<S> cayley_action(const element<S>& xi, const element<S>& mu) {
    return turned(cayley_of(generator_of(xi)), mu);
  }
  /// Right to rounding for |u| < 1/2.
  template <class S>
  [[gnu::noinline]] static element<S> dexp_inv(const element<S>& u, const element<S>& v) {
    return dexp_inv_by_series<su>(u, v);
  }

  /// |mu|, then tr H^j / n, j = 3 … n, of H = sum mu_k J_k: they fix its eigenvalues.
  template <class S>
  static vec<S, 1 - most_rows> casimirs(const element<S>& mu) {
    const int n = rows_of(mu.size);
    const auto traces = power_traces(hermitian(mu), n);
    vec<S, 1 - most_rows> out(n - 1);
    for (int j = 2; j <= n; ++j) out[j - 2] = traces[j];
    out[0] = square_root(out[0]);
    return out;
  }
  /// What a change of each is measured by: itself, or where j is odd, and it may be zero, the mean of its neighbours.
  template <class S>
  static vec<S, 1 - most_rows> casimir_sizes(const element<S>& mu) {
    const int n = rows_of(mu.size);
    const auto traces = power_traces(hermitian(mu), n + 1);
    vec<S, 1 - most_rows> out(n - 1);
    for (int j = 2; j <= n; ++j) out[j - 2] = j % 2 == 0 ? traces[j] : square_root(S(traces[j - 1] * traces[j + 1]));
    out[0] = square_root(out[0]);
    return out;
  }

  /// A point of the orbit of `onto` next to mu: H + sum_k c_k H^k, k = 0 … n-1, its c_k by Newton's method. Where
  /// eigenvalues coincide |mu| alone is put right.
  template <class S>
  [[gnu::noinline]] static element<S> orbit_projection(const element<S>& mu, const element<S>& onto) {
    constexpr int corrections = 5;
    const int n = rows_of(mu.size);
    const S size = square_root(dot(onto, onto)), unit = S(1.0) / size;
    const auto asked = power_traces(hermitian(unit * onto), n);
    auto h = hermitian(unit * mu);
    for (int i = 0; i < corrections; ++i) {
      const auto c = correction(power_traces(h, 2 * n - 2), asked, n);
      auto sum = c[n - 1] * matrix<S>::identity(2 * n);
      for (int k = n - 2; k >= 0; --k) sum = sum * h + c[k] * matrix<S>::identity(2 * n);
      h = h + sum;
    }
    return size * modes_of(h);
  }

 private:
  /// U^-1 H U.
  template <class S>
  static element<S> turned(const matrix<S>& nearly, const element<S>& mu) {
    const auto u = orthogonal(nearly);
    auto inverse = u;
    for (int i = 0; i < u.n; ++i)
      for (int j = 0; j < u.n; ++j) inverse(i, j) = u(j, i);
    return modes_of(inverse * (hermitian(mu) * u));
  }

  template <class S>
  using traces = vec<S, 1 - 2 * most_rows>;
  /// tr H^j / n, j = 0 … last.
  template <class S>
  static traces<S> power_traces(const matrix<S>& h, int last) {
    traces<S> out(last + 1);
    out[0] = S(1.0);
    auto power = h;
    for (int j = 2; j <= last; j += 2) {
      out[j] = S(1.0 / h.n) * dot(power.entries, power.entries);
      if (j == last) break;
      const auto next = power * h;
      out[j + 1] = S(1.0 / h.n) * dot(power.entries, next.entries);
      power = next;
    }
    return out;
  }
  /// Of the c_k: tr H^j / n = q_j is asked to be a_j, and changes by j sum_k q_(j-1+k) c_k, j = 1 … n.
  template <class S>
  static vec<S, -most_rows> correction(const traces<S>& q, const traces<S>& asked, int n) {
    using numbers = vec<S, -most_rows>;
    auto slopes = zeros<polhode::matrix<S, -most_rows>>(n);
    numbers missing(n), scaling(n);
    for (int j = 0; j < n; ++j) {
      slopes[j] = numbers(n);
      for (int k = 0; k < n; ++k) slopes[j][k] = q[j + k];
      missing[j] = S(1.0 / (j + 1)) * (asked[j + 1] - q[j + 1]);
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
