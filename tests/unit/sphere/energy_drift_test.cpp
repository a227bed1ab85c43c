// SPDX-License-Identifier: Apache-2.0
// The mean energy under noise alone: sums over the sphere, the semigroup by another road, and second differences along
// the rotations that noise makes.
#include "sphere/closed_forms/energy_drift.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sphere/expectations/expectation.hpp"

namespace polhode {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Noise along three directions that are not orthogonal.
Matrix3d noise_vectors() {
  Matrix3d out;
  out << 0.4, 0.1, 0, -0.1, 0.3, 0.2, 0.05, 0, 0.5;
  return out;
}

sphere_problem body_in_field(const Matrix3d& covariance, const Vector3d& field = Vector3d::Zero()) {
  auto p = body_on_sphere({1, 2, 3}, 0.7, 1.3, covariance);
  p.field = field;
  return p;
}

points_on_sphere some_points(double radius) {
  points_on_sphere out(3, 3);
  out << 0.6, 0.48, 0.64, 0, -0.6, 0.8, -1, 0, 0;
  return radius * out;
}

TEST(MeanEnergy, OverTheSphereIsItsSum) {
  const auto p = body_in_field(Matrix3d::Identity());
  const auto rule = sphere_quadrature(4);
  double sum = 0;
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i)
    sum += rule.weights[i] * p.energy(p.radius * rule.points.row(i).transpose());
  EXPECT_NEAR(mean_energy_over_sphere(p), sum / rule.weights.sum(), 1e-14);
}

// Dissipation has no part in it.
TEST(MeanEnergy, WithoutDissipationIsTheExpectation) {
  const Matrix3d skew = noise_vectors() * noise_vectors().transpose();
  for (const auto& p :
       {body_in_field(0.16 * Matrix3d::Identity()), body_in_field(skew),
        body_in_field(0.16 * Matrix3d::Identity(), {0.3, -0.2, 0.1}), body_in_field(skew, {0.3, -0.2, 0.1})}) {
    auto free = p;
    free.damping = 0;
    const auto from = some_points(p.radius);
    const auto found = energy_without_dissipation(p, from, 0.8);
    EXPECT_LT(found.uncertainty, 1e-11);
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
      const auto truth = expectation(free, *named_observable("energy", free), from.row(i).transpose(), 0.8, 1e-12);
      EXPECT_NEAR(found.value[i], *truth.value, 2e-12) << i;
    }
  }
}

// Rounding of the greatest energy where nothing else is uncertain.
TEST(MeanEnergy, IsAsUncertainAsRounding) {
  const auto from = some_points(1.3);
  const auto isotropic = body_in_field(0.16 * Matrix3d::Identity()),
             tilted = body_in_field(noise_vectors() * noise_vectors().transpose());
  double greatest = 0;
  for (Eigen::Index i = 0; i < from.rows(); ++i)
    greatest = std::max(greatest, isotropic.energy(from.row(i).transpose()));
  EXPECT_DOUBLE_EQ(energy_without_dissipation(isotropic, from, 1).uncertainty, 1e-15 * greatest);
  EXPECT_DOUBLE_EQ(energy_without_dissipation(tilted, from, 1e-3).uncertainty, 1e-14 * greatest);
}

TEST(MeanEnergy, IsAsUncertainAsRoundingOfWhatTheFieldAdds) {
  const auto from = some_points(1.3);
  const auto p = body_in_field(0.16 * Matrix3d::Identity(), {0.3, -0.2, 0.1});
  double greatest = 0;
  for (Eigen::Index i = 0; i < from.rows(); ++i)
    greatest = std::max(greatest, std::fabs(p.energy(from.row(i).transpose())));
  EXPECT_DOUBLE_EQ(energy_without_dissipation(p, from, 1e-3).uncertainty, 1e-14 * greatest);
}

// Where the degree does not do, it is seen which it is.
TEST(MeanEnergy, IsThatOfDegreeTwentyAndUncertainByThatOfSixteen) {
  auto p = body_in_field(0.01 * Vector3d(1, 2, 3).asDiagonal());
  p.damping = 0;
  const auto from = some_points(p.radius);
  const auto found = energy_without_dissipation(p, from, 12);
  double change = 0;
  for (Eigen::Index i = 0; i < from.rows(); ++i) {
    const auto at = [&](int degree) {
      return *expectation(p, *named_observable("energy", p), from.row(i).transpose(), 12, 1e-11, degree).value;
    };
    EXPECT_NEAR(found.value[i], at(20), 1e-12) << i;
    change = std::max(change, std::fabs(at(20) - at(16)));
  }
  EXPECT_GT(change, 1e-9);
  EXPECT_NEAR(found.uncertainty, change, 1e-12);
}

// Fast turns under weak noise: the degree does not do, the error is what the degree changes, and it is said.
TEST(MeanEnergy, SaysHowFarItsDegreeReaches) {
  auto p = body_in_field(0.01 * Vector3d(1, 2, 3).asDiagonal());
  p.damping = 0;
  const auto from = some_points(p.radius);
  for (const double time : {12.0, 20.0}) {
    const auto found = energy_without_dissipation(p, from, time);
    double error = 0;
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
      const auto truth = expectation(p, *named_observable("energy", p), from.row(i).transpose(), time, 1e-11);
      ASSERT_TRUE(truth.converged()) << truth.reason;
      error = std::max(error, std::fabs(found.value[i] - *truth.value));
    }
    EXPECT_GT(found.uncertainty, error) << time;
    EXPECT_LT(found.uncertainty, 100 * error) << time;
  }
}

// 1/2 sum_i d^2/de^2 h(exp(e sigma_i) Pi): the free motion keeps h.
TEST(EnergyDrift, IsTheSecondDerivativeAlongTheNoise) {
  const Matrix3d sigma = noise_vectors();
  const auto p = body_in_field(sigma * sigma.transpose(), {0.3, -0.2, 0.1});
  const auto at = some_points(p.radius);
  const auto found = energy_drift(p, at);
  for (Eigen::Index i = 0; i < at.rows(); ++i) {
    const Vector3d pi = at.row(i).transpose();
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double e = 1e-3, size = sigma.col(k).norm();
      const auto turned = [&](double angle) {
        return p.energy(Eigen::AngleAxisd(angle * size, sigma.col(k) / size) * pi);
      };
      sum += (turned(e) - 2 * turned(0) + turned(-e)) / (2 * e * e);
    }
    EXPECT_NEAR(found[i], sum, 1e-7) << i;
  }
}

}  // namespace
}  // namespace polhode
