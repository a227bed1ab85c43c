// SPDX-License-Identifier: Apache-2.0
// A turn about an axis by at most a few thousandths of a radian, as three shears: three fused products.
#pragma once

#include <algorithm>

#include <polhode/chebyshev.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// The turn by t x about an axis, x the component on it, |x| <= reach: with s = sin(t x), h = tan(t x / 2)
///   a += h b,   b -= s a,   a += h b
/// is a = a cos + b sin, b = b cos - a sin. s/x and h/x are polynomials in x^2; cubes of t (for degree 2, fifth powers)
/// and squares of x must be normal numbers. Degree 1 errs in the angle by (t reach)^5 / 960 at most, degree 2 by (t
/// reach)^7 / 37,000.
template <int degree>
struct shear_rotation {
  polynomial<degree> sine{}, half_tangent{};

  shear_rotation() = default;
  shear_rotation(double t, double reach) {
    const long double bound = std::max(static_cast<long double>(t) * reach * t * reach, 1e-300L);
    sine = chebyshev_interpolation<degree>([](long double q) { return detail::cosine_series(q, 1); }, bound);
    half_tangent = chebyshev_interpolation<degree>(
        [](long double q) { return detail::cosine_series(q, 2) / detail::cosine_series(q, 1); }, bound);
    double power = t;
    for (int k = 0; k <= degree; ++k, power *= t * t)
      for (auto* p : {&sine, &half_tangent}) (*p)[static_cast<std::size_t>(k)] *= power;
  }

  template <int axis, class S>
  [[nodiscard]] vec<S, 3> about(const vec<S, 3>& pi) const {
    constexpr int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const S x = pi[axis], q = x * x;
    const S s = x * evaluate(sine, q), h = x * evaluate(half_tangent, q);
    const S sheared = pi[next] + h * pi[last], b = pi[last] - s * sheared, a = sheared + h * b;
    vec<S, 3> out;
    out[axis] = x;
    out[next] = a;
    out[last] = b;
    return out;
  }
};

}  // namespace polhode
