// so(n), skew n x n matrices, and its dual, n from 3 to 6, known at run time by the size of a vector: the entries above
// the diagonal, (1,2), (1,3), …, (2,3), …
//
//   [xi, eta] as matrices X Y - Y X,   coad(xi, mu) = ad*_xi mu = M X - X M,   exp_action(xi, mu) = exp(-X) M exp(X)
//
// Of n = 3 this is lie/so3.hpp with M = mu^, the matrix of mu x: M_12 = -mu_3, M_13 = mu_2, M_23 = -mu_1.
#pragma once

#include <type_traits>

#include <polhode/lie/bracket_series.hpp>
#include <polhode/lie/fixed_matrix.hpp>
#include <polhode/lie/matrix_functions.hpp>
#include <polhode/lie/skew_exponential.hpp>
#include <polhode/lie/small_matrix.hpp>
#include <polhode/scalar.hpp>
#include <polhode/solve.hpp>
#include <polhode/vec.hpp>

namespace polhode {

struct son {
  static constexpr int most_rows = 6, dimension = -most_rows * (most_rows - 1) / 2;
  template <class S>
  using element = vec<S, dimension>;
  template <class S>
  using matrix = small_matrix<S, most_rows>;

  /// n of a vector of n (n - 1) / 2 components.
  static constexpr int rows_of(int components) {
    int n = 3;
    while (n * (n - 1) / 2 < components) ++n;
    return n;
  }
  /// The place of entry (i, j), i < j, of n rows.
  static constexpr int place(int n, int i, int j) { return i * n - i * (i + 1) / 2 + (j - i - 1); }

  template <class S>
  static matrix<S> as_matrix(const element<S>& v) {
    matrix<S> out(rows_of(v.size));
    int k = 0;
    for (int i = 0; i < out.n; ++i)
      for (int j = i + 1; j < out.n; ++j, ++k) {
        out(i, j) = v[k];
        out(j, i) = -v[k];
      }
    return out;
  }
  template <class Matrix, class S = typename Matrix::scalar>
  static element<S> above_diagonal(const Matrix& m) {
    element<S> out(m.n * (m.n - 1) / 2);
    int k = 0;
    for (int i = 0; i < m.n; ++i)
      for (int j = i + 1; j < m.n; ++j, ++k) out[k] = m(i, j);
    return out;
  }

  /// The same of n rows known to the compiler; and f of that number.
  template <int n, class S>
  static fixed_matrix<S, n> skew(const element<S>& v) {
    fixed_matrix<S, n> out;
    int k = 0;
    for (int i = 0; i < n; ++i) {
      out(i, i) = S(0.0);
      for (int j = i + 1; j < n; ++j, ++k) {
        out(i, j) = v[k];
        out(j, i) = -v[k];
      }
    }
    return out;
  }
  template <class F>
  static auto of_rows(int components, F f) {
    switch (components) {
      case 3: return f(std::integral_constant<int, 3>{});
      case 6: return f(std::integral_constant<int, 4>{});
      case 10: return f(std::integral_constant<int, 5>{});
      default: return f(std::integral_constant<int, 6>{});
    }
  }

  /// X Y - Y X.
  template <class S>
  [[gnu::noinline]] static element<S> bracket(const element<S>& xi, const element<S>& eta) {
    return of_rows(xi.size, [&]<int n>(std::integral_constant<int, n>) {
      const auto x = skew<n>(xi), y = skew<n>(eta);
      element<S> out(xi.size);
      int place = 0;
      for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) out[place++] = product_entry(x, y, i, j) - product_entry(y, x, i, j);
      return out;
    });
  }
  template <class S>
  static element<S> coad(const element<S>& xi, const element<S>& mu) {
    return bracket(mu, xi);
  }
  template <class S>
  [[gnu::noinline]] static element<S> exp_action(const element<S>& xi, const element<S>& mu) {
    return of_rows(xi.size, [&]<int n>(std::integral_constant<int, n>) {
      return mu + above_diagonal(skew_conjugation(skew_exponential_less_one(skew<n>(xi)), skew<n>(mu)));
    });
  }
  /// By the orthogonal matrix (1 - X/2)^-1 (1 + X/2). Of n = 3 the Cayley transform of the coadjoint operator; of n > 3
  /// that one would keep quadratic Casimirs alone.
  template <class S>
  [[gnu::noinline]] static element<S> cayley_action(const element<S>& xi, const element<S>& mu) {
    return mu + above_diagonal(conjugation(cayley_less_one(as_matrix(xi)), as_matrix(mu)));
  }

  /// -X M X.
  template <class S>
  [[gnu::noinline]] static element<S> sandwich(const element<S>& xi, const element<S>& mu) {
    const auto x = as_matrix(xi);
    return above_diagonal(S(-1.0) * (x * as_matrix(mu) * x));
  }

  /// Right to rounding for |u| < 1/2.
  template <class S>
  [[gnu::noinline]] static element<S> dexp_inv(const element<S>& u, const element<S>& v) {
    return dexp_inv_by_series<son>(u, v);
  }

  /// |mu| = (tr M^T M / 2)^(1/2), then tr (M^T M)^k / 2, k = 2 … n/2: they fix the eigenvalues of M.
  template <class S>
  static vec<S, -most_rows / 2> casimirs(const element<S>& mu) {
    const int n = rows_of(mu.size);
    const auto traces = power_traces(as_matrix(mu), n / 2);
    vec<S, -most_rows / 2> out(n / 2);
    for (int k = 0; k < out.size; ++k) out[k] = traces[k];
    out[0] = square_root(out[0]);
    return out;
  }

  /// A point of the orbit of `onto` next to mu: M sum_k c_k (M^T M)^k, its c_k by Newton's method from (1, 0, …). Where
  /// eigenvalues coincide |mu| alone is put right. Written as what is added to mu, and Casimirs as their differences,
  /// so that both round to their own size.
  template <class S>
  [[gnu::noinline]] static element<S> orbit_projection(const element<S>& mu, const element<S>& onto) {
    constexpr int corrections = 6;
    const int casimirs = rows_of(mu.size) / 2;
    const auto target = as_matrix(onto), start = as_matrix(mu), way = as_matrix(onto - mu);
    auto added = as_matrix(zeros<element<S>>(mu.size));
    for (int i = 0; i < corrections; ++i) {
      const auto m = start + added;
      const auto square = S(-1.0) * (m * m);
      const auto c = correction(power_traces(m, 2 * casimirs),
                                trace_changes(m, target, way + S(-1.0) * added, casimirs), casimirs);
      auto power = m;
      for (int k = 0; k < casimirs; ++k) {
        added = added + c[k] * power;
        power = power * square;
      }
    }
    return mu + above_diagonal(added);
  }

 private:
  static constexpr int most_casimirs = most_rows / 2;
  template <class S>
  using traces = vec<S, -2 * most_casimirs>;

  /// tr (M^T M)^k / 2, k = 1 … count.
  template <class S>
  static traces<S> power_traces(const matrix<S>& m, int count) {
    const auto square = S(-1.0) * (m * m);
    auto power = square;
    traces<S> out(count);
    for (int k = 0; k < count; ++k) {
      if (k > 0) power = power * square;
      S sum(0.0);
      for (int i = 0; i < m.n; ++i) sum = sum + power(i, i);
      out[k] = S(0.5) * sum;
    }
    return out;
  }

  /// What tr (M^T M)^k / 2 change by from m to t = m + way, k = 1 … count: with P = M^T M, of t and of m,
  /// tr P_t^k - P_m^k = tr (P_t - P_m) sum_j P_t^(k-1-j) P_m^j, and P_m - P_t = way t + m way.
  template <class S>
  static traces<S> trace_changes(const matrix<S>& m, const matrix<S>& t, const matrix<S>& way, int count) {
    const auto square_m = S(-1.0) * (m * m), square_t = S(-1.0) * (t * t), change = S(-1.0) * (way * t + m * way);
    auto powers = matrix<S>::identity(m.n), power = powers;
    traces<S> out(count);
    for (int k = 0; k < count; ++k) {
      if (k > 0) {
        power = power * square_t;
        powers = powers * square_m + power;
      }
      out[k] = S(0.5) * dot(change.entries, powers.entries);
    }
    return out;
  }

  /// Of the c_k: q_k (k = 1 …) is to change by change_k, and changes by sum_j 2 k q_(k+j-1) dc_j.
  template <class S>
  static vec<S, -most_casimirs> correction(const traces<S>& q, const traces<S>& change, int count) {
    using numbers = vec<S, -most_casimirs>;
    auto slopes = zeros<polhode::matrix<S, -most_casimirs>>(count);
    numbers missing(count), scaling(count);
    for (int k = 0; k < count; ++k) {
      slopes[k] = numbers(count);
      for (int j = 0; j < count; ++j) slopes[k][j] = S(2.0 * (k + 1)) * q[k + j];
      missing[k] = change[k];
    }
    scaling[0] = missing[0] / (S(2.0) * q[0]);
    const auto c = times(inverse(slopes), missing);
    S most(0.0);
    for (int k = 0; k < count; ++k) most = most + magnitude(c[k] * q[k]);
    const auto regular = most < S(10.0) * q[0];  // not where it is no number
    numbers out(count);
    for (int k = 0; k < count; ++k) out[k] = select(regular, c[k], scaling[k]);
    return out;
  }
};

}  // namespace polhode
