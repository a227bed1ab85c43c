// SPDX-License-Identifier: Apache-2.0
// Elementary functions that a step may call on any scalar. For packs they are branch-free in the common case, and
// the value of a lane never depends on its neighbours.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace polhode {

/// Whether S is a pack of numbers. polhode/simd.hpp says so of those that it brings, and what they do in a way of their
/// own: for whoever steps packs; others need not wait for their compiler to read it.
template <class S>
inline constexpr bool is_pack = false;
template <class Pack>
struct of_packs;

template <class S>
requires is_pack<S> S select(const typename S::mask_type& condition, const S& yes, const S& no) {
  return of_packs<S>::select(condition, yes, no);
}
template <std::floating_point S>
S select(bool condition, const S& yes, S no) {
  return condition ? yes : no;
}

template <class S>
requires is_pack<S>
bool any(const S&, const typename S::mask_type& mask) { return of_packs<S>::any(mask); }
template <std::floating_point S>
bool any(S, bool mask) {
  return mask;
}

template <std::floating_point S>
S square_root(S x) {
  return std::sqrt(x);
}
template <class S>
requires is_pack<S> S square_root(const S& x) { return of_packs<S>::square_root(x); }

template <std::floating_point S>
S magnitude(S x) {
  return std::fabs(x);
}
template <class S>
requires is_pack<S> S magnitude(const S& x) { return of_packs<S>::magnitude(x); }

/// The bits of a scalar: 64 per lane.
template <class S>
struct bits_of_scalar {
  using type = typename of_packs<S>::bits;
};
template <>
struct bits_of_scalar<double> {
  using type = std::uint64_t;
};
template <class S>
using bits_of = typename bits_of_scalar<S>::type;

template <class S>
struct sine_cosine {
  S sin, cos;
};

namespace detail {

// Cody-Waite reduction by pi/2 in three parts and the kernel polynomials on [-pi/4, pi/4]; below 1 ulp for
// |x| < reduction_limit. (Method and constants: W. J. Cody, W. Waite, Software Manual for the Elementary Functions,
// 1980, ch. 8; minimax coefficients as in FreeBSD msun k_sin.c and k_cos.c.)
inline constexpr double reduction_limit = 1e5;

/// Below this no argument needs a reduction: round(2 x / pi) is 0.
inline constexpr double unreduced_limit = 0.785;

/// For |x| < pi/4 and a little more.
template <class S>
sine_cosine<S> sincos_near(const S& r) {
  const S z = r * r;
  const S sin = r + r * z *
                        (S(-1.66666666666666324348e-01) +
                         z * (S(8.33333333332248946124e-03) +
                              z * (S(-1.98412698298579493134e-04) +
                                   z * (S(2.75573137070700676789e-06) +
                                        z * (S(-2.50507602534068634195e-08) + z * S(1.58969099521155010221e-10))))));
  const S tail = z * z *
                 (S(4.16666666666666019037e-02) +
                  z * (S(-1.38888888888741095749e-03) +
                       z * (S(2.48015872894767294178e-05) +
                            z * (S(-2.75573143513906633035e-07) +
                                 z * (S(2.08757232129817482790e-09) + z * S(-1.13596475577881948265e-11))))));
  // 1 - z/2 + tail, with the rounding of 1 - z/2 given back.
  const S half = S(0.5) * z;
  const S head = S(1.0) - half;
  return {sin, head + (((S(1.0) - head) - half) + tail)};
}

template <class S>
sine_cosine<S> sincos_reduced(const S& x) {
  constexpr double round_to_integer = 0x1.8p52;
  const S quotient = (x * S(0.63661977236758134308) + S(round_to_integer)) - S(round_to_integer);
  const S r = ((x - quotient * S(1.57079632673412561417e+00)) - quotient * S(6.07710050630396597660e-11)) -
              quotient * S(2.02226624879595063154e-21);
  const auto [sin, cos] = sincos_near(r);
  // Quadrant from quotient mod 4, in floating point: q in {-2, -1, 0, 1, 2}.
  const S q = quotient - S(4.0) * ((quotient * S(0.25) + S(round_to_integer)) - S(round_to_integer));
  const auto odd = magnitude(q) == S(1.0);
  const S s = select(odd, cos, sin), c = select(odd, sin, cos);
  const auto upside_down = magnitude(q) == S(2.0);
  return {select(upside_down || q == S(-1.0), S(-s), s), select(upside_down || q == S(1.0), S(-c), c)};
}

}  // namespace detail

/// Natural logarithm of a normal number > 0, below 1 ulp. With x = 2^e m, m in [sqrt(1/2), sqrt(2)), and s =
/// (m-1)/(m+1): log m = 2 artanh s. (Minimax coefficients as in FreeBSD msun e_log.c.)
template <class S>
S logarithm(const S& x) {
  using B = bits_of<S>;
  // Adding the distance from sqrt(1/2) to 1 to the bits makes the exponent step at sqrt(1/2) instead of 1.
  const B shifted = std::bit_cast<B>(x) + B(std::uint64_t{0x3FF0000000000000} - std::uint64_t{0x3FE6A09E00000000});
  const S e = std::bit_cast<S>(B((shifted >> 52) | B(std::uint64_t{0x4330000000000000}))) - S(0x1p52 + 1023);
  const S m =
      std::bit_cast<S>(B((shifted & B(std::uint64_t{0x000FFFFFFFFFFFFF})) + B(std::uint64_t{0x3FE6A09E00000000})));
  const S f = m - S(1.0), s = f / (S(2.0) + f), z = s * s;
  const S r = z * (S(6.666666666666735130e-01) +
                   z * (S(3.999999999940941908e-01) +
                        z * (S(2.857142874366239149e-01) +
                             z * (S(2.222219843214978396e-01) +
                                  z * (S(1.818357216161805012e-01) +
                                       z * (S(1.531383769920937332e-01) + z * S(1.479819860511658591e-01)))))));
  const S half = S(0.5) * f * f;
  return e * S(6.93147180369123816490e-01) - ((half - (s * (half + r) + e * S(1.90821492927058770002e-10))) - f);
}

/// Exponential, below 1 ulp; 0 below -708 and infinity above 709, where the result would leave the normal numbers.
/// (Reduction by log 2 in two parts and minimax coefficients as in FreeBSD msun e_exp.c.)
template <class S>
S exponential(const S& x) {
  using B = bits_of<S>;
  constexpr double round_to_integer = 0x1.8p52;
  const S shifted = x * S(1.44269504088896338700) + S(round_to_integer), k = shifted - S(round_to_integer);
  const S high = x - k * S(6.93147180369123816490e-01), low = k * S(1.90821492927058770002e-10);
  const S r = high - low, t = r * r;
  const S c = r - t * (S(1.66666666666666019037e-01) +
                       t * (S(-2.77777777770155933842e-03) +
                            t * (S(6.61375632143793436117e-05) +
                                 t * (S(-1.65339022054652515390e-06) + t * S(4.13813679705723846039e-08)))));
  const S y = S(1.0) - ((low - (r * c) / (S(2.0) - c)) - high);
  const S scaled = std::bit_cast<S>(B(std::bit_cast<B>(y) + (std::bit_cast<B>(shifted) << 52)));
  const S above = select(x > S(709.0), S(std::numeric_limits<double>::infinity()), scaled);
  return select(x < S(-708.0), S(0.0), above);
}

namespace detail {

/// Lanes beyond the reduction's reach, by the standard library; out of line, as this is compiled at every call.
template <class S>
[[gnu::cold, gnu::noinline]] void correct_far(const S& x, sine_cosine<S>& result) {
  if constexpr (is_pack<S>) {
    for (std::size_t lane = 0; lane < S::size(); ++lane)
      if (std::fabs(x[lane]) > reduction_limit) {
        result.sin[lane] = std::sin(x[lane]);
        result.cos[lane] = std::cos(x[lane]);
      }
  } else {
    result = {std::sin(x), std::cos(x)};
  }
}

}  // namespace detail

namespace detail {

/// Out of line, as is what follows it: steps of some length alone have such angles.
template <class S>
[[gnu::noinline]] sine_cosine<S> sincos_far(const S& x) {
  auto result = sincos_reduced(x);
  if (any(x, magnitude(x) > S(reduction_limit))) [[unlikely]]
    correct_far(x, result);
  return result;
}

}  // namespace detail

/// Sine and cosine of any finite argument. Where all lanes are near 0 nothing is reduced, with the same bits.
template <class S>
sine_cosine<S> sincos(const S& x) {
  if (any(x, magnitude(x) > S(detail::unreduced_limit))) [[unlikely]]
    return detail::sincos_far(x);
  return detail::sincos_near(x);
}

// The constants above are those of doubles.
inline float logarithm(float x) { return static_cast<float>(logarithm<double>(x)); }
inline float exponential(float x) { return static_cast<float>(exponential<double>(x)); }
inline sine_cosine<float> sincos(float x) {
  const auto [sin, cos] = sincos<double>(x);
  return {static_cast<float>(sin), static_cast<float>(cos)};
}

}  // namespace polhode
