// SPDX-License-Identifier: Apache-2.0
#include "sphere/closed_forms/elliptic_moments.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <numbers>

namespace polhode {

elliptic_moments elliptic_moments_of(double m, double left) {
  const double one = boost::math::ellint_rf(0.0, left, 1.0), sin2 = boost::math::ellint_rd(0.0, left, 1.0) / 3;
  const double series = 3 / 8.0 + m * (5 / 32.0 + m * (105 / 1024.0 + m * 315 / 4096.0));
  const double sin4 = m > 1e-3 ? (2 * (1 + m) * sin2 - one) / (3 * m) : std::numbers::pi / 2 * series;
  return {one, sin2, sin4};
}

}  // namespace polhode
