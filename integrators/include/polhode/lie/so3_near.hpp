// so(3) for rotations that are mostly small: the coadjoint calculus of so3.hpp with exp by polynomials in |xi|^2, to
// the same accuracy. A lane whose angle is larger takes the closed form, so a value never depends on its neighbours.
#pragma once

#include <polhode/chebyshev.hpp>
#include <polhode/lie/so3.hpp>

namespace polhode {

/// Polynomials of that degree for |xi| < reach. Their error (cosine_polynomial) must lie far below rounding: lengths
/// change by it in the same direction at every step, so that they would drift like n, not like the root of n. |xi| <
/// 2e5, which a normal increment never reaches where most rotations are small.
template <int degree, double reach>
struct so3_near : so3 {
  using so3::exp_action;

  /// sin|xi| / |xi| and (1 - cos|xi|) / |xi|^2, in |xi|^2.
  static constexpr auto sinc = cosine_polynomial<degree>(1, reach* reach);
  static constexpr auto cosc = cosine_polynomial<degree>(2, reach* reach);

  template <class S>
  static vec<S, 3> exp_action(const vec<S, 3>& xi, const vec<S, 3>& mu) {
    const S q = dot(xi, xi);
    S first = evaluate(sinc, q), second = evaluate(cosc, q);
    if (any(q, q > S(reach * reach))) [[unlikely]]
      correct_far(q, first, second);
    return rotated(first, second, xi, mu);
  }

 private:
  /// Out of the loop's way: inlined it would be compiled, and its registers reserved, at every rotation.
  template <class S>
  [[gnu::cold, gnu::noinline]] static void correct_far(const S& q, S& first, S& second) {
    const S half = S(0.5) * square_root(q);
    const auto [sin, cos] = detail::sincos_reduced(half);
    const S ratio = sin / half;
    const auto far = q > S(reach * reach);
    first = select(far, S(ratio * cos), first);
    second = select(far, S(S(0.5) * ratio * ratio), second);
  }
};

}  // namespace polhode
