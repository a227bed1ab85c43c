// Mean squares beside an equilibrium: closed forms, and the whole second moment by Kronecker products.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <unsupported/Eigen/KroneckerProduct>

#include "sphere/closed_forms/linearised_body.hpp"

namespace polhode {
namespace {

constexpr std::array<double, 3> inertia{1, 2, 3};

// The middle axis without noise and dissipation: lengths grow like exp(t c sqrt(-a b)), a = -1/6, b = 1/2.
TEST(LinearisedBody, GrowsBesideTheMiddleAxisAsThePendulumDoes) {
  EXPECT_NEAR(mean_square_growth(linearised_about(1, inertia, 0, 2, 0)), 4 / std::sqrt(12.0), 1e-14);
  EXPECT_NEAR(mean_square_growth(linearised_about(0, inertia, 0, 2, 0)), 0, 1e-8);
}

// Infinitely strong noise averages over all directions: sum of the dissipation's rates, -theta c^2 (a + b).
TEST(LinearisedBody, StrongNoiseLeavesTheMeanOfTheRates) {
  const double a = 1.0 / 1 - 1.0 / 3, b = 1.0 / 2 - 1.0 / 3;
  EXPECT_NEAR(mean_square_growth(linearised_about(2, inertia, 0.5, 1, 1000)), -0.5 * (a + b), 1e-6);
}

// dM = (K + K^T) M dt, K = A + sigma^2 R^2 / 2 on both factors, and sigma^2 R x R.
TEST(LinearisedBody, IsTheSpectralAbscissaOfTheSecondMoment) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double theta : {0.0, 0.3, 2.0})
      for (const double sigma : {0.0, 0.2, 1.5}) {
        const auto body = linearised_about(axis, inertia, theta, 1.3, sigma);
        Eigen::Matrix2d a, r;
        a << body.drift[0][0], body.drift[0][1], body.drift[1][0], body.drift[1][1];
        r << 0, 1, -1, 0;
        const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), ito = a + sigma * sigma / 2 * r * r;
        const Eigen::Matrix4d both = Eigen::kroneckerProduct(ito, one).eval() +
                                     Eigen::kroneckerProduct(one, ito).eval() +
                                     sigma * sigma * Eigen::kroneckerProduct(r, r).eval();
        EXPECT_NEAR(mean_square_growth(body), both.eigenvalues().real().maxCoeff(), 1e-7) << axis;
      }
}

}  // namespace
}  // namespace polhode
