// SPDX-License-Identifier: Apache-2.0
// Complex n x n matrices over any scalar, n known to the compiler.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include <polhode/called.hpp>
#include <polhode/scalar.hpp>

namespace polhode {

template <class S>
struct complex_number {
  S real{0.0}, imaginary{0.0};

  friend complex_number operator+(const complex_number& a, const complex_number& b) {
    return {a.real + b.real, a.imaginary + b.imaginary};
  }
  friend complex_number operator-(const complex_number& a, const complex_number& b) {
    return {a.real - b.real, a.imaginary - b.imaginary};
  }
  friend complex_number operator-(const complex_number& a) { return {-a.real, -a.imaginary}; }
  friend complex_number operator*(const complex_number& a, const complex_number& b) {
    return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
  }
  friend complex_number operator*(const S& s, const complex_number& a) { return {s * a.real, s * a.imaginary}; }
};

/// sum + a b, in four fused operations.
template <class S>
complex_number<S> plus_product(const complex_number<S>& sum, const complex_number<S>& a, const complex_number<S>& b) {
  return {sum.real + a.real * b.real - a.imaginary * b.imaginary,
          sum.imaginary + a.real * b.imaginary + a.imaginary * b.real};
}
template <class S>
complex_number<S> conjugate(const complex_number<S>& a) {
  return {a.real, -a.imaginary};
}
template <class S>
complex_number<S> reciprocal(const complex_number<S>& a) {
  return (S(1.0) / (a.real * a.real + a.imaginary * a.imaginary)) * conjugate(a);
}
template <class Mask, class S>
complex_number<S> select(const Mask& condition, const complex_number<S>& yes, const complex_number<S>& no) {
  return {select(condition, yes.real, no.real), select(condition, yes.imaginary, no.imaginary)};
}

/// c x. Of a dual number part by part, as a constant has no slope.
template <class S>
S times_constant(double c, const S& x) {
  if constexpr (requires { x.slope; })
    return {times_constant(c, x.value), decltype(x.value)(c) * x.slope};
  else
    return S(c) * x;
}
template <class S>
complex_number<S> times_constant(double c, const complex_number<S>& x) {
  return {times_constant(c, x.real), times_constant(c, x.imaginary)};
}
template <class S>
complex_number<S> times_constant(const complex_number<double>& c, const complex_number<S>& x) {
  return {times_constant(c.real, x.real) - times_constant(c.imaginary, x.imaginary),
          times_constant(c.real, x.imaginary) + times_constant(c.imaginary, x.real)};
}

/// Row by row.
template <class S, int N>
struct complex_matrix {
  using scalar = S;
  using entry = complex_number<S>;
  static constexpr int n = N;
  static complex_matrix identity(int) {
    complex_matrix out;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) out(i, j) = {S(i == j ? 1.0 : 0.0), S(0.0)};
    return out;
  }

  union {
    std::array<entry, N * N> entries;
  };

  complex_matrix() {}  // its entries are not set
  /// Entry by entry: as one block of bytes a compiler copies it in words narrower than a pack.
  complex_matrix(const complex_matrix& other) {
    for (std::size_t k = 0; k < N * N; ++k) std::construct_at(&entries[k], other.entries[k]);
  }
  complex_matrix& operator=(const complex_matrix& other) {
    for (std::size_t k = 0; k < N * N; ++k) entries[k] = other.entries[k];
    return *this;
  }
  entry& operator()(int i, int j) { return entries[static_cast<std::size_t>(N * i + j)]; }
  const entry& operator()(int i, int j) const { return entries[static_cast<std::size_t>(N * i + j)]; }

  /// The sum of the squares of the entries' sizes.
  S square() const { return real_product(*this, *this); }
  /// The real part of tr A* B.
  friend S real_product(const complex_matrix& a, const complex_matrix& b) {
    S sum(0.0);
    for (std::size_t k = 0; k < N * N; ++k)
      sum = sum + (a.entries[k].real * b.entries[k].real + a.entries[k].imaginary * b.entries[k].imaginary);
    return sum;
  }

  friend complex_matrix operator+(complex_matrix a, const complex_matrix& b) {
    for (std::size_t k = 0; k < N * N; ++k) a.entries[k] = a.entries[k] + b.entries[k];
    return a;
  }
  friend complex_matrix operator-(complex_matrix a, const complex_matrix& b) {
    for (std::size_t k = 0; k < N * N; ++k) a.entries[k] = a.entries[k] - b.entries[k];
    return a;
  }
  friend complex_matrix operator*(const S& s, complex_matrix a) {
    for (auto& x : a.entries) x = s * x;
    return a;
  }
  POLHODE_CALLED friend complex_matrix operator*(const complex_matrix& a, const complex_matrix& b) {
    complex_matrix out;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) {
        entry sum = a(i, 0) * b(0, j);
        for (int k = 1; k < N; ++k) sum = plus_product(sum, a(i, k), b(k, j));
        out(i, j) = sum;
      }
    return out;
  }
};

namespace detail {

/// Row i of a b from column i on.
template <class S, int n>
[[gnu::always_inline]] inline void upper_row(const complex_matrix<S, n>& a, const complex_matrix<S, n>& b, int i,
                                             complex_matrix<S, n>& out) {
  for (int j = i; j < n; ++j) {
    auto sum = a(i, 0) * b(0, j);
    for (int k = 1; k < n; ++k) sum = plus_product(sum, a(i, k), b(k, j));
    out(i, j) = sum;
  }
}

}  // namespace detail

/// a b where it is known to be Hermitian: half of the entries are computed.
template <class S, int n>
POLHODE_CALLED complex_matrix<S, n> self_adjoint_product(const complex_matrix<S, n>& a, const complex_matrix<S, n>& b) {
  complex_matrix<S, n> out;
  for (int i = 0; i < n; ++i) {
    detail::upper_row(a, b, i, out);
    out(i, i).imaginary = S(0.0);
    for (int j = i + 1; j < n; ++j) out(j, i) = conjugate(out(i, j));
  }
  return out;
}

/// a b where it is known to be skew-Hermitian.
template <class S, int n>
POLHODE_CALLED complex_matrix<S, n> skew_product(const complex_matrix<S, n>& a, const complex_matrix<S, n>& b) {
  complex_matrix<S, n> out;
  for (int i = 0; i < n; ++i) {
    detail::upper_row(a, b, i, out);
    out(i, i).real = S(0.0);
    for (int j = i + 1; j < n; ++j) out(j, i) = -conjugate(out(i, j));
  }
  return out;
}

template <class S, int n>
complex_matrix<S, n> adjoint(const complex_matrix<S, n>& a) {
  complex_matrix<S, n> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out(i, j) = conjugate(a(j, i));
  return out;
}

}  // namespace polhode
