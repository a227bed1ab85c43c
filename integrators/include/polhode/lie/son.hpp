// SPDX-License-Identifier: Apache-2.0
// so(n), skew n x n matrices, and its dual, n from 3 to 6, known at run time by the size of a vector: the entries above
// the diagonal, (1,2), (1,3), …, (2,3), …
//
//   [xi, eta] as matrices X Y - Y X,   coad(xi, mu) = ad*_xi mu = M X - X M,   exp_action(xi, mu) = exp(-X) M exp(X)
//
// Of n = 3 this is lie/so3.hpp with M = mu^, the matrix of mu x: M_12 = -mu_3, M_13 = mu_2, M_23 = -mu_1.
#pragma once

#include <type_traits>

#include <polhode/called.hpp>
#include <polhode/lie/bracket_series.hpp>
#include <polhode/lie/fixed_matrix.hpp>
#include <polhode/lie/matrix_functions.hpp>
#include <polhode/lie/skew_exponential.hpp>
#include <polhode/lie/skew_projection.hpp>
#include <polhode/lie/small_matrix.hpp>
#include <polhode/scalar.hpp>
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
  POLHODE_CALLED static element<S> bracket(const element<S>& xi, const element<S>& eta) {
    return of_rows(xi.size, [&]<int n>(std::integral_constant<int, n>) {
      return above_diagonal(skew_commutator(skew<n>(xi), skew<n>(eta)));
    });
  }
  template <class S>
  static element<S> coad(const element<S>& xi, const element<S>& mu) {
    return bracket(mu, xi);
  }
  template <class S>
  POLHODE_CALLED static element<S> exp_action(const element<S>& xi, const element<S>& mu) {
    return of_rows(xi.size, [&]<int n>(std::integral_constant<int, n>) {
      return mu + above_diagonal(skew_conjugation(skew_exponential_less_one(skew<n>(xi)), skew<n>(mu)));
    });
  }
  /// By the orthogonal matrix (1 - X/2)^-1 (1 + X/2). Of n = 3 the Cayley transform of the coadjoint operator; of n > 3
  /// that one would keep quadratic Casimirs alone.
  template <class S>
  POLHODE_CALLED static element<S> cayley_action(const element<S>& xi, const element<S>& mu) {
    return of_rows(xi.size, [&]<int n>(std::integral_constant<int, n>) {
      return mu + above_diagonal(skew_conjugation(cayley_less_one(skew<n>(xi)), skew<n>(mu)));
    });
  }

  /// -X M X.
  template <class S>
  POLHODE_CALLED static element<S> sandwich(const element<S>& xi, const element<S>& mu) {
    return of_rows(xi.size, [&]<int n>(std::integral_constant<int, n>) {
      const auto x = skew<n>(xi);
      return -above_diagonal(skew_product(x * skew<n>(mu), x));
    });
  }

  /// Right to rounding for |u| < 1/2.
  template <class S>
  POLHODE_CALLED static element<S> dexp_inv(const element<S>& u, const element<S>& v) {
    return dexp_inv_by_series<son>(u, v);
  }

  /// |mu| = (tr M^T M / 2)^(1/2), then tr (M^T M)^k / 2, k = 2 … n/2: they fix the eigenvalues of M.
  template <class S>
  static vec<S, -most_rows / 2> casimirs(const element<S>& mu) {
    return of_rows(mu.size, [&]<int n>(std::integral_constant<int, n>) {
      const auto traces = detail::skew_traces(detail::skew_powers<n / 2>(skew<n>(mu)));
      vec<S, -most_rows / 2> out(n / 2);
      for (int k = 0; k < out.size; ++k) out[k] = traces[k];
      out[0] = square_root(out[0]);
      return out;
    });
  }

  /// A point of the orbit of `onto` next to mu (lie/skew_projection.hpp).
  template <class S>
  POLHODE_CALLED static element<S> orbit_projection(const element<S>& mu, const element<S>& onto) {
    // At |mu| = 1, where traces of powers neither overflow nor vanish.
    const S size = square_root(dot(onto, onto)), unit = S(1.0) / size;
    return of_rows(mu.size, [&]<int n>(std::integral_constant<int, n>) {
      const auto apart = skew<n>(unit * (onto - mu));
      return mu + size * above_diagonal(skew_projection(skew<n>(unit * mu), skew<n>(unit * onto), apart));
    });
  }
};

}  // namespace polhode
