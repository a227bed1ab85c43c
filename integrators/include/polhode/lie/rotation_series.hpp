// SPDX-License-Identifier: Apache-2.0
// The coefficients of Rodrigues' formula and of its integral, in the square of the angle.
#pragma once

#include <array>

#include <polhode/chebyshev.hpp>
#include <polhode/scalar.hpp>

namespace polhode {

/// sin t / t, (1 - cos t)/t^2 and, of three, (1 - sin t / t)/t^2 of q = t^2, any finite q: for t < reach polynomials of
/// that degree, for a lane beyond it the closed forms, so a value never depends on its neighbours. The polynomials'
/// error (cosine_polynomial) must lie far below rounding: lengths change by it in the same direction at every step, so
/// that they would drift like n, not like the root of n.
template <int degree, double reach, int count = 2>
struct rotation_series {
  static constexpr auto sinc = cosine_polynomial<degree>(1, reach* reach);
  static constexpr auto cosc = cosine_polynomial<degree>(2, reach* reach);
  static constexpr auto third = cosine_polynomial<degree>(3, reach* reach);

  template <class S>
  static std::array<S, count> of(const S& q) {
    std::array<S, count> out;
    out[0] = evaluate(sinc, q);
    out[1] = evaluate(cosc, q);
    if constexpr (count > 2) out[2] = evaluate(third, q);
    if (any(q, q > S(reach * reach))) [[unlikely]]
      correct_far(q, out);
    return out;
  }

 private:
  /// Out of the loop's way: inlined it would be compiled, and its registers reserved, at every rotation. (1 - cos
  /// t)/t^2 is taken as sinc(t/2)^2 / 2, which does not cancel.
  template <class S>
  [[gnu::cold, gnu::noinline]] static void correct_far(const S& q, std::array<S, count>& out) {
    const S half = S(0.5) * square_root(q);
    const auto [sin, cos] = sincos(half);
    const S ratio = sin / half, first = ratio * cos;
    const auto far = q > S(reach * reach);
    out[0] = select(far, first, out[0]);
    out[1] = select(far, S(S(0.5) * ratio * ratio), out[1]);
    if constexpr (count > 2) out[2] = select(far, S((S(1.0) - first) / q), out[2]);
  }
};

}  // namespace polhode
