// SPDX-License-Identifier: Apache-2.0
// Square matrices of n rows, n known to the compiler: loops over them are written out, and a product of the size of a
// step stays near the registers.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include <polhode/called.hpp>

namespace polhode {

template <class S, int rows>
struct fixed_matrix {
  using scalar = S;
  using entry = S;
  static constexpr int n = rows;
  static fixed_matrix identity(int) {
    fixed_matrix out;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) out(i, j) = S(i == j ? 1.0 : 0.0);
    return out;
  }
  union {
    std::array<S, static_cast<std::size_t>(n* n)> entries;
  };

  fixed_matrix() {}  // its entries are not set, which for dual numbers takes the union

  S& operator()(int i, int j) { return entries[static_cast<std::size_t>(n * i + j)]; }
  const S& operator()(int i, int j) const { return entries[static_cast<std::size_t>(n * i + j)]; }

  friend fixed_matrix operator+(fixed_matrix a, const fixed_matrix& b) {
    for (std::size_t k = 0; k < a.entries.size(); ++k) a.entries[k] = a.entries[k] + b.entries[k];
    return a;
  }
  friend fixed_matrix operator*(const S& s, fixed_matrix a) {
    for (auto& entry : a.entries) entry = s * entry;
    return a;
  }
};

namespace detail {

/// Row i of a b from column `first` on: the sums of a row side by side, in registers.
template <int first, class S, int n>
[[gnu::always_inline]] inline void product_row(const fixed_matrix<S, n>& a, const fixed_matrix<S, n>& b, int i,
                                               fixed_matrix<S, n>& out) {
  if constexpr (first < n) {
    std::array<S, static_cast<std::size_t>(n - first)> sums;
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] = a(i, 0) * b(0, first + static_cast<int>(j));
    for (int k = 1; k < n; ++k)
      for (std::size_t j = 0; j < sums.size(); ++j) sums[j] = sums[j] + a(i, k) * b(k, first + static_cast<int>(j));
    for (std::size_t j = 0; j < sums.size(); ++j) out(i, first + static_cast<int>(j)) = sums[j];
  }
}

}  // namespace detail

template <class S, int n>
POLHODE_CALLED fixed_matrix<S, n> operator*(const fixed_matrix<S, n>& a, const fixed_matrix<S, n>& b) {
  fixed_matrix<S, n> out;
  [&]<int... i>(std::integer_sequence<int, i...>) { (detail::product_row<0>(a, b, i, out), ...); }
  (std::make_integer_sequence<int, n>());
  return out;
}

/// a b where it is known to be symmetric: half of the entries are computed.
template <class S, int n>
POLHODE_CALLED fixed_matrix<S, n> self_adjoint_product(const fixed_matrix<S, n>& a, const fixed_matrix<S, n>& b) {
  fixed_matrix<S, n> out;
  [&]<int... i>(std::integer_sequence<int, i...>) { (detail::product_row<i>(a, b, i, out), ...); }
  (std::make_integer_sequence<int, n>());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) out(j, i) = out(i, j);
  return out;
}

/// a b where it is known to be skew.
template <class S, int n>
POLHODE_CALLED fixed_matrix<S, n> skew_product(const fixed_matrix<S, n>& a, const fixed_matrix<S, n>& b) {
  fixed_matrix<S, n> out;
  [&]<int... i>(std::integer_sequence<int, i...>) { (detail::product_row<i + 1>(a, b, i, out), ...); }
  (std::make_integer_sequence<int, n>());
  for (int i = 0; i < n; ++i) {
    out(i, i) = S(0.0);
    for (int j = i + 1; j < n; ++j) out(j, i) = -out(i, j);
  }
  return out;
}

/// a b - b a of skew matrices, which is skew: their diagonals, zeros, are left out of the sums.
template <class S, int n>
fixed_matrix<S, n> skew_commutator(const fixed_matrix<S, n>& a, const fixed_matrix<S, n>& b) {
  fixed_matrix<S, n> out;
  for (int i = 0; i < n; ++i) {
    out(i, i) = S(0.0);
    for (int j = i + 1; j < n; ++j) {
      const int first = i > 0 ? 0 : j > 1 ? 1 : 2;  // neither i nor j
      S sum = a(i, first) * b(first, j) - b(i, first) * a(first, j);
      for (int k = first + 1; k < n; ++k)
        if (k != i && k != j) sum = sum + (a(i, k) * b(k, j) - b(i, k) * a(k, j));
      out(i, j) = sum;
      out(j, i) = -sum;
    }
  }
  return out;
}

/// The sum of a_ij b_ij.
template <class S, int n>
S inner_product(const fixed_matrix<S, n>& a, const fixed_matrix<S, n>& b) {
  S sum = a.entries[0] * b.entries[0];
  for (std::size_t k = 1; k < a.entries.size(); ++k) sum = sum + a.entries[k] * b.entries[k];
  return sum;
}

template <class S, int n>
fixed_matrix<S, n> transposed(const fixed_matrix<S, n>& a) {
  fixed_matrix<S, n> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out(i, j) = a(j, i);
  return out;
}

}  // namespace polhode
