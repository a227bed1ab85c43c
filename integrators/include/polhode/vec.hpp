// SPDX-License-Identifier: Apache-2.0
// A short vector over any scalar: double, a pack of doubles, or a dual number.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace polhode {

/// Coordinates of an element of a Lie algebra or of its dual, in a fixed basis. S is the scalar, N the dimension.
template <class S, int N>
struct vec {
  using scalar = S;
  static constexpr int size = N;
  std::array<S, N> c{};

  constexpr S& operator[](int i) { return c[static_cast<std::size_t>(i)]; }
  constexpr const S& operator[](int i) const { return c[static_cast<std::size_t>(i)]; }
  constexpr S* begin() { return c.data(); }
  constexpr S* end() { return begin() + N; }
  constexpr const S* begin() const { return c.data(); }
  constexpr const S* end() const { return begin() + N; }

  friend constexpr vec operator+(vec a, const vec& b) {
    for (int i = 0; i < N; ++i) a[i] = a[i] + b[i];
    return a;
  }
  friend constexpr vec operator-(vec a, const vec& b) {
    for (int i = 0; i < N; ++i) a[i] = a[i] - b[i];
    return a;
  }
  friend constexpr vec operator-(vec a) {
    for (int i = 0; i < N; ++i) a[i] = -a[i];
    return a;
  }
  friend constexpr vec operator*(const S& s, vec a) {
    for (int i = 0; i < N; ++i) a[i] = s * a[i];
    return a;
  }
};

/// At most -N numbers, N < 0: how many is known when the program runs, and loops go over those alone. Without any it
/// stands for zero in a sum.
template <class S, int N>
requires(N < 0) struct vec<S, N> {
  using scalar = S;
  static constexpr int capacity = -N;
  int size = 0;

  vec() {}
  /// So many zeros.
  explicit vec(int n) : size(n) {
    for (int i = 0; i < size; ++i) std::construct_at(begin() + i);
  }
  vec(const vec& other) : size(other.size) {
    for (int i = 0; i < size; ++i) std::construct_at(begin() + i, other[i]);
  }
  vec& operator=(const vec& other) {
    size = other.size;
    for (int i = 0; i < size; ++i) (*this)[i] = other[i];
    return *this;
  }

  S& operator[](int i) { return c_[static_cast<std::size_t>(i)]; }
  const S& operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }
  S* begin() { return c_.data(); }
  S* end() { return begin() + size; }
  const S* begin() const { return c_.data(); }
  const S* end() const { return begin() + size; }

  friend vec operator+(vec a, const vec& b) {
    if (b.size == 0) return a;
    if (a.size == 0) return b;
    for (int i = 0; i < a.size; ++i) a[i] = a[i] + b[i];
    return a;
  }
  friend vec operator-(vec a, const vec& b) {
    if (b.size == 0) return a;
    if (a.size == 0) return -b;
    for (int i = 0; i < a.size; ++i) a[i] = a[i] - b[i];
    return a;
  }
  friend vec operator-(vec a) {
    for (int i = 0; i < a.size; ++i) a[i] = -a[i];
    return a;
  }
  friend vec operator*(const S& s, vec a) {
    for (int i = 0; i < a.size; ++i) a[i] = s * a[i];
    return a;
  }

 private:
  union {
    std::array<S, capacity> c_;  // the first `size` of them exist
  };
};

/// Zeros, as many as a type of fixed size has, or n.
template <class Vector>
constexpr Vector zeros(int n) {
  if constexpr (requires { Vector::capacity; })
    return Vector(n);
  else
    return Vector{};
}

/// Zero as a type: what is absent costs nothing. A step written for vectors drops the terms in which it appears.
struct zero {
  friend constexpr zero operator+(zero, zero) { return {}; }
  template <class S>
  friend constexpr const S& operator+(const S& s, zero) {
    return s;
  }
  template <class S>
  friend constexpr const S& operator+(zero, const S& s) {
    return s;
  }
};

/// The zero vector of any dimension.
struct zero_vector {
  constexpr zero operator[](int) const { return {}; }
  friend constexpr zero_vector operator+(zero_vector, zero_vector) { return {}; }
  friend constexpr zero_vector operator-(zero_vector) { return {}; }
  template <class S, int N>
  friend constexpr vec<S, N> operator+(vec<S, N> a, zero_vector) {
    return a;
  }
  template <class S, int N>
  friend constexpr vec<S, N> operator+(zero_vector, vec<S, N> a) {
    return a;
  }
  template <class S>
  friend constexpr zero_vector operator*(const S&, zero_vector) {
    return {};
  }
};

template <class S, int N>
constexpr S dot(const vec<S, N>& a, const vec<S, N>& b) {
  S sum = a[0] * b[0];
  for (int i = 1; i < a.size; ++i) sum = sum + a[i] * b[i];
  return sum;
}

template <class S>
constexpr vec<S, 3> cross(const vec<S, 3>& a, const vec<S, 3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Componentwise product with constants: diag(d) a.
template <class S, int N>
constexpr vec<S, N> scaled(const vec<double, N>& d, vec<S, N> a) {
  for (int i = 0; i < a.size; ++i) a[i] = S(d[i]) * a[i];
  return a;
}

}  // namespace polhode
