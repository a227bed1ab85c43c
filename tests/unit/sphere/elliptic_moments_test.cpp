// SPDX-License-Identifier: Apache-2.0
// Elliptic moments against their integrals.
#include "sphere/closed_forms/elliptic_moments.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

// Either side of where the series ends, and up to the separatrix.
TEST(EllipticMoments, AreTheirIntegrals) {
  boost::math::quadrature::tanh_sinh<double> rule;
  for (const double m : {0.0, 1e-6, 5e-4, 0.9999e-3, 1.0001e-3, 0.01, 0.3, 0.9, 0.999}) {
    const auto integral = [&](int power) {
      return rule.integrate(
          [&](double phi) { return std::pow(std::sin(phi), power) / std::sqrt(1 - m * std::pow(std::sin(phi), 2)); },
          0.0, std::numbers::pi / 2, 1e-14);
    };
    const auto found = elliptic_moments_of(m, 1 - m);
    EXPECT_NEAR(found.one, integral(0), 1e-13 * found.one) << m;
    EXPECT_NEAR(found.sin2, integral(2), 1e-13 * found.sin2) << m;
    EXPECT_NEAR(found.sin4, integral(4), 1e-12 * found.sin4) << m;
  }
}

}  // namespace
}  // namespace polhode
