// SPDX-License-Identifier: Apache-2.0
// Mean squares beside an equilibrium: closed forms, and the whole second moment by Kronecker products.
#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/KroneckerProduct>

#include "algebra/decompositions.hpp"
#include "sphere/closed_forms/linearised.hpp"

namespace polhode {
namespace {

/// Beside axis 1 to 3 of the body with inertia (1, 2, 3).
linearised_equation beside(int axis, double theta, double momentum, double sigma) {
  const auto body = body_on_sphere({1, 2, 3}, theta, momentum, Eigen::Matrix3d::Zero());
  return linearised_about(body, Eigen::Vector3d::Unit(axis), sigma);
}

// The middle axis without noise and dissipation: lengths grow like exp(t c sqrt(-a b)), a = -1/6, b = 1/2.
TEST(Linearised, GrowsBesideTheMiddleAxisAsThePendulumDoes) {
  EXPECT_NEAR(mean_square_growth(beside(1, 0, 2, 0)), 4 / std::sqrt(12.0), 1e-14);
  EXPECT_NEAR(mean_square_growth(beside(0, 0, 2, 0)), 0, 1e-8);
}

// Infinitely strong noise averages over all directions: sum of the dissipation's rates, -theta c^2 (a + b).
TEST(Linearised, StrongNoiseLeavesTheMeanOfTheRates) {
  const double a = 1.0 / 1 - 1.0 / 3, b = 1.0 / 2 - 1.0 / 3;
  EXPECT_NEAR(mean_square_growth(beside(2, 0.5, 1, 1000)), -0.5 * (a + b), 1e-6);
}

// dM = (K + K^T) M dt, K = A + sigma^2 R^2 / 2 on both factors, and sigma^2 R x R.
TEST(Linearised, IsTheSpectralAbscissaOfTheSecondMoment) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double theta : {0.0, 0.3, 2.0})
      for (const double sigma : {0.0, 0.2, 1.5}) {
        const auto body = beside(axis, theta, 1.3, sigma);
        const Eigen::Matrix2d a = body.drift;
        Eigen::Matrix2d r;
        r << 0, 1, -1, 0;
        const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), ito = a + sigma * sigma / 2 * r * r;
        const Eigen::Matrix4d both = Eigen::kroneckerProduct(ito, one).eval() +
                                     Eigen::kroneckerProduct(one, ito).eval() +
                                     sigma * sigma * Eigen::kroneckerProduct(r, r).eval();
        EXPECT_NEAR(mean_square_growth(body), eigenvalues_of(both).real().maxCoeff(), 1e-7) << axis;
      }
}

}  // namespace
}  // namespace polhode
