// SPDX-License-Identifier: Apache-2.0
// Every change in one program: which of them acts is said by POLHODE_MUTANT when it starts, and which were come by is
// written to POLHODE_REACHED when it ends. all_in_one.py writes `a + b` as `a - plus<7>{} - b`: an operator of the same
// precedence keeps what belongs together, and is one that nothing else answers to; of `a && b` it writes both chains.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace polhode_mutant {

inline int active = -1;
inline unsigned char reached[POLHODE_MUTANTS];  // 1: come by; 2: come by only where the change does not compile

inline struct session {
  session() {
    if (const char* number = std::getenv("POLHODE_MUTANT")) active = std::atoi(number);
  }
  ~session() {
    const char* path = std::getenv("POLHODE_REACHED");
    if (path == nullptr) return;
    if (std::FILE* file = std::fopen(path, "wb")) {
      std::fwrite(reached, 1, sizeof reached, file);
      std::fclose(file);
    }
  }
} the_session;

template <int id>
constexpr bool on() {
  if (std::is_constant_evaluated()) return false;
  reached[id] = 1;
  return active == id;
}

template <int id>
constexpr void refused() {
  if (!std::is_constant_evaluated() && reached[id] == 0) reached[id] = 2;
}

/// No expression that refers to what is gone at the end of the line.
template <class T>
constexpr auto plain(T&& x) {
  if constexpr (requires { x.eval(); })
    return x.eval();
  else
    return std::decay_t<T>(std::forward<T>(x));
}

template <int id, class Op, class A>
struct half {
  A&& a;
};

#define POLHODE_MUTANT_OPERATOR(name, carrier, op, other)                                             \
  template <int id>                                                                                   \
  struct name {};                                                                                     \
  template <int id, class A>                                                                          \
  constexpr half<id, name<id>, A> operator carrier(A&& a, name<id>) {                                 \
    return {std::forward<A>(a)};                                                                      \
  }                                                                                                   \
  template <int id, class A, class B>                                                                 \
  requires requires(A && a, B && b) { std::forward<A>(a) op std::forward<B>(b); }                     \
  constexpr auto operator carrier(half<id, name<id>, A> h, B&& b) {                                   \
    using result = decltype(plain(std::forward<A>(h.a) op std::forward<B>(b)));                       \
    if constexpr (requires { static_cast<result>(std::forward<A>(h.a) other std::forward<B>(b)); }) { \
      if (on<id>()) return static_cast<result>(std::forward<A>(h.a) other std::forward<B>(b));        \
    } else {                                                                                          \
      refused<id>();                                                                                  \
    }                                                                                                 \
    return plain(std::forward<A>(h.a) op std::forward<B>(b));                                         \
  }
POLHODE_MUTANT_OPERATOR(plus, -, +, -)
POLHODE_MUTANT_OPERATOR(minus, -, -, +)
POLHODE_MUTANT_OPERATOR(times, /, *, /)
POLHODE_MUTANT_OPERATOR(over, /, /, *)
POLHODE_MUTANT_OPERATOR(less, <=, <, <=)
POLHODE_MUTANT_OPERATOR(at_most, <=, <=, <)
POLHODE_MUTANT_OPERATOR(more, <=, >, >=)
POLHODE_MUTANT_OPERATOR(at_least, <=, >=, >)
POLHODE_MUTANT_OPERATOR(equal, !=, ==, !=)
POLHODE_MUTANT_OPERATOR(unequal, !=, !=, ==)
#undef POLHODE_MUTANT_OPERATOR

#define POLHODE_MUTANT_ASSIGNMENT(name, op, other)                                                    \
  template <int id>                                                                                   \
  struct name {};                                                                                     \
  template <int id, class B>                                                                          \
  constexpr half<id, name<id>, B> operator|=(name<id>, B&& b) {                                       \
    return {std::forward<B>(b)};                                                                      \
  }                                                                                                   \
  template <int id, class A, class B>                                                                 \
  constexpr decltype(auto) operator|=(A&& a, half<id, name<id>, B> h) {                               \
    using result = decltype(std::forward<A>(a) op std::forward<B>(h.a));                              \
    if constexpr (requires { static_cast<result>(std::forward<A>(a) other std::forward<B>(h.a)); }) { \
      if (on<id>()) return static_cast<result>(std::forward<A>(a) other std::forward<B>(h.a));        \
    } else {                                                                                          \
      refused<id>();                                                                                  \
    }                                                                                                 \
    return static_cast<result>(std::forward<A>(a) op std::forward<B>(h.a));                           \
  }
POLHODE_MUTANT_ASSIGNMENT(add, +=, -=)
POLHODE_MUTANT_ASSIGNMENT(subtract, -=, +=)
POLHODE_MUTANT_ASSIGNMENT(multiply, *=, /=)
POLHODE_MUTANT_ASSIGNMENT(divide, /=, *=)
#undef POLHODE_MUTANT_ASSIGNMENT

template <int id>
struct negated {};
template <int id, class A>
constexpr auto operator/(negated<id>, A&& a) {
  using result = decltype(plain(-std::forward<A>(a)));
  if constexpr (requires { static_cast<result>(std::forward<A>(a)); })
    if (on<id>()) return static_cast<result>(std::forward<A>(a));
  return plain(-std::forward<A>(a));
}

template <int id, class T>
constexpr T constant(T value, T changed) {
  return on<id>() ? changed : value;
}

/// Not known when compiled, so that what depends on it is computed when the program begins.
template <int id, class T>
T constant_at_start(T value, T changed) {
  return constant<id>(value, changed);
}

template <int id>
constexpr bool omitted() {
  return on<id>();
}

#define POLHODE_MUTANT_CALL(name, call, other)                \
  template <int id, class... A>                               \
  constexpr auto name(A&&... a) {                             \
    if (on<id>()) return plain(other(std::forward<A>(a)...)); \
    return plain(call(std::forward<A>(a)...));                \
  }                                                           \
  template <int id, class T>                                  \
  constexpr T name(std::initializer_list<T> a) {              \
    if constexpr (requires { call(a); })                      \
      if (on<id>()) return other(a);                          \
    return call(a);                                           \
  }
POLHODE_MUTANT_CALL(max_not_min, std::max, std::min)
POLHODE_MUTANT_CALL(min_not_max, std::min, std::max)
#undef POLHODE_MUTANT_CALL
template <int id, class T>
constexpr auto sin_not_cos(T x) {
  return on<id>() ? std::cos(x) : std::sin(x);
}
template <int id, class T>
constexpr auto cos_not_sin(T x) {
  return on<id>() ? std::sin(x) : std::cos(x);
}

}  // namespace polhode_mutant
