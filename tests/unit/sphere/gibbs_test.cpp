// SPDX-License-Identifier: Apache-2.0
// The distribution of the energy under the Gibbs law: next to a well, where two axes are alike, and by sums over the
// sphere.
#include "sphere/closed_forms/gibbs.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Where the distribution is held, as a share of the energies.
double node(int n) {
  const auto smoothstep = [](double s) { return s * s * (3 - 2 * s); };
  return smoothstep(smoothstep(n / 600.0));
}

// In the well of the third axis h rises by t y, t = 1 - x_3^2, y = y(phi): sums over the angle and t. Up to fifty
// temperatures it is held.
TEST(Gibbs, NextToAWellIsASumOverAnglesAndHeights) {
  const double beta = 1e4, a = (1 - 1 / 3.0) / 2, b = (1 / 2.0 - 1 / 3.0) / 2;
  const auto up_to = [&](double e) {
    constexpr int angles = 64;
    double sum = 0;
    for (int i = 0; i < angles; ++i) {
      const double y = b + (a - b) * std::pow(std::cos(2 * std::numbers::pi * i / angles), 2);
      sum += boost::math::quadrature::gauss<double, 60>::integrate(
          [&](double t) { return std::exp(-beta * t * y) / std::sqrt(1 - t); }, 0, e / y);
    }
    return sum;
  };
  const gibbs_law law({1, 2, 3}, 1, beta);
  for (const int n : {60, 90, 120, 150}) {
    const double e = 50 / beta * node(n);
    EXPECT_NEAR(law.energy_cdf(law.least_energy() + e), up_to(e) / up_to(40 / beta), 1e-9) << n;
  }
}

// h = c^2 / (2 I) -+ a z^2, z uniform: P(h' <= h) is that of |z|, at both ends as a root of the energy.
TEST(Gibbs, OfBodiesOfRevolutionWithoutATemperatureIsUniformInHeight) {
  const double c = 1.2, a = (1 - 1 / 2.5) / 2;
  const gibbs_law least_at_the_equator({1, 2.5, 2.5}, c, 0), least_at_the_poles({1, 1, 2.5}, c, 0);
  for (const double z : {1e-6, 1.5e-5, 0.1, 0.5, 0.9, 0.9999, 0.99999999}) {
    const double rise = a * c * c * z * z;
    EXPECT_NEAR(least_at_the_equator.energy_cdf(least_at_the_equator.least_energy() + rise), z, 4e-6) << z;
    EXPECT_NEAR(least_at_the_poles.energy_cdf(least_at_the_poles.greatest_energy() - rise), 1 - z, 4e-6) << z;
    EXPECT_GE(least_at_the_equator.energy_cdf(least_at_the_equator.least_energy() + rise), 0) << z;
    EXPECT_LE(least_at_the_poles.energy_cdf(least_at_the_poles.greatest_energy() - rise), 1) << z;
  }
}

sphere_problem uniaxial(double k) {
  return {.quadratic = Vector3d(0, 0, k).asDiagonal(), .damping = 0, .radius = 1, .covariance = Matrix3d::Identity()};
}

/// The share of a sphere's points of that height at most; 0 is one of the rings.
double share_below(double z) {
  const auto rule = sphere_quadrature(800);
  return (rule.points.col(2).array().abs() <= z).select(rule.weights.array(), 0).sum() / rule.weights.sum();
}

// From a ring of points of least energy on; nothing is below it.
TEST(Gibbs, ByQuadratureCountsPointsFromTheLeast) {
  const auto law = gibbs_law::by_quadrature(uniaxial(2));
  for (const int n : {1, 2, 250, 599}) EXPECT_NEAR(law.energy_cdf(node(n)), share_below(std::sqrt(node(n))), 1e-8) << n;
  EXPECT_LT(law.energy_cdf(1e-13), 0.2 * share_below(0));
  EXPECT_EQ(law.energy_cdf(1), 1);
}

// To a ring of points of the greatest.
TEST(Gibbs, ByQuadratureCountsPointsToTheGreatest) {
  const auto law = gibbs_law::by_quadrature(uniaxial(-2));
  for (const int n : {350, 599})
    EXPECT_NEAR(law.energy_cdf(node(n) - 1), 1 - share_below(std::sqrt(1 - node(n))), 1e-8) << n;
  EXPECT_GT(law.energy_cdf(-1e-13), 1 - 0.2 * share_below(0));
}

// So narrow a law that half as many points in a direction are too few: of each moment what that changes, the greatest.
TEST(Gibbs, ByQuadratureIsAsUncertainAsHalfThePoints) {
  const double beta = 8e3;
  const sphere_problem p{.quadratic = Vector3d(0.2, 0, 0).asDiagonal(),
                         .damping = beta / 2,
                         .radius = 1,
                         .covariance = Matrix3d::Identity(),
                         .field = Vector3d(0, 0, 1)};
  const auto moments = [&](int degree) -> Eigen::Array4d {  // of the energy above the least, and of squares
    const auto rule = sphere_quadrature(degree);
    Eigen::Array4d sum = Eigen::Array4d::Zero();
    double total = 0;
    for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
      const Vector3d pi = rule.points.row(i).transpose();
      const double above = 0.1 * pi[0] * pi[0] + 1 + pi[2], mass = rule.weights[i] * std::exp(-beta * above);
      sum += mass * Eigen::Array4d(above, pi[0] * pi[0], pi[1] * pi[1], pi[2] * pi[2]);
      total += mass;
    }
    return sum / total;
  };
  const double change = (moments(800) / moments(400) - 1).abs().maxCoeff();
  EXPECT_GT(change, 1e-6);
  EXPECT_NEAR(gibbs_law::by_quadrature(p).relative_uncertainty(), change, 1e-10);
}

}  // namespace
}  // namespace polhode::test
