// SPDX-License-Identifier: Apache-2.0
// The polar angle of a point of the plane, branch-free, for a double or a pack of them.
#pragma once

#include <numbers>

#include <polhode/scalar.hpp>

namespace polhode {

/// The angle in (-pi, pi] of (x, y), as atan2(y, x) but for the sign of a zero, which does not count; 0 for the origin.
/// Within 6e-16 in radians (the sum of its roundings) for finite x and y whose sum does not overflow. With t = min/max
/// of |x|, |y|: above tan(pi/8) the argument is (t - 1)/(t + 1) and pi/4 is added. (Minimax coefficients as in FreeBSD
/// msun s_atan.c.)
template <class S>
S angle_of(const S& y, const S& x) {
  const S a = magnitude(x), b = magnitude(y);
  const auto steep = b > a;
  const S most = select(steep, b, a), least = select(steep, a, b);
  const auto beyond = least > S(0.41421356237309504880) * most;
  const S over = select(beyond, S(least - most), least), under = select(beyond, S(most + least), most);
  const S t = over / select(under > S(0.0), under, S(1.0)), z = t * t, w = z * z;
  const S even = z * (S(3.33333333333329318027e-01) +
                      w * (S(1.42857142725034663711e-01) +
                           w * (S(9.09088713343650656196e-02) +
                                w * (S(6.66107313738753120669e-02) +
                                     w * (S(4.97687799461593236017e-02) + w * S(1.62858201153657823623e-02))))));
  const S odd = w * (S(-1.99999999998764832476e-01) +
                     w * (S(-1.11111104054623557880e-01) +
                          w * (S(-7.69187620504482999495e-02) +
                               w * (S(-5.83357013379057348645e-02) + w * S(-3.65315727442169155270e-02)))));
  const S arc = t - t * (even + odd);
  const S first = select(beyond, S(S(std::numbers::pi / 4) + arc), arc);
  const S upper = select(steep, S(S(std::numbers::pi / 2) - first), first);
  const S half = select(x < S(0.0), S(S(std::numbers::pi) - upper), upper);
  return select(y < S(0.0), S(-half), half);
}

}  // namespace polhode
