// A short vector over any scalar: double, a pack of doubles, or a dual number.
#pragma once

#include <array>
#include <cstddef>

namespace polhode {

/// Coordinates of an element of a Lie algebra or of its dual, in a fixed basis. S is the scalar, N the dimension.
template <class S, int N>
struct vec {
  using scalar = S;
  static constexpr int size = N;
  std::array<S, N> c{};

  constexpr S& operator[](int i) { return c[static_cast<std::size_t>(i)]; }
  constexpr const S& operator[](int i) const { return c[static_cast<std::size_t>(i)]; }

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
  for (int i = 1; i < N; ++i) sum = sum + a[i] * b[i];
  return sum;
}

template <class S>
constexpr vec<S, 3> cross(const vec<S, 3>& a, const vec<S, 3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Componentwise product with constants: diag(d) a.
template <class S, int N>
constexpr vec<S, N> scaled(const vec<double, N>& d, vec<S, N> a) {
  for (int i = 0; i < N; ++i) a[i] = S(d[i]) * a[i];
  return a;
}

}  // namespace polhode
