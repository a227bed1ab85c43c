// SPDX-License-Identifier: Apache-2.0
#include "sphere/harmonics/harmonics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

TEST(Harmonics, AreOrthonormalUnderTheQuadrature) {
  for (const int degree : {0, 1, 7, 40}) {
    const auto rule = sphere_quadrature(2 * degree);
    const Eigen::MatrixXd y = harmonics(rule.points, degree);
    const Eigen::MatrixXd gram = y.transpose() * rule.weights.asDiagonal() * y;
    EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(), 2e-13) << degree;
  }
}

TEST(Harmonics, AgreeWithStandardLibraryAndAtThePoles) {
  const Eigen::VectorXd y = harmonics_at(start, 6);
  const double polar = std::acos(start[2]), phi = std::atan2(start[1], start[0]);
  for (unsigned l = 0; l <= 6; ++l)
    for (unsigned m = 0; m <= l; ++m) {
      // std::sph_legendre has the Condon-Shortley sign
      const double p = std::sph_legendre(l, m, polar) * (m % 2 ? -1 : 1) * (m == 0 ? 1 : std::numbers::sqrt2);
      const int up = harmonic_index(int(l), int(m)), down = harmonic_index(int(l), -int(m));
      EXPECT_NEAR(y[up], p * std::cos(m * phi), 1e-14);
      EXPECT_NEAR(m > 0 ? y[down] : 0, p * std::sin(m * phi), 1e-14);
    }
  const Eigen::VectorXd pole = harmonics_at({0, 0, -1}, 90);
  for (int l = 0; l <= 90; ++l)
    EXPECT_NEAR(pole[harmonic_index(l, 0)], (l % 2 ? -1 : 1) * std::sqrt((2 * l + 1) / (4 * std::numbers::pi)), 1e-12);
}

TEST(SphereQuadrature, IntegratesMonomialsUpToItsDegreeAndNoFurther) {
  const auto rule = sphere_quadrature(10);
  const auto integral = [&](int a, int b, int c) {
    const auto x = rule.points.array();
    return (rule.weights.array() * x.col(0).pow(a) * x.col(1).pow(b) * x.col(2).pow(c)).sum();
  };
  const double area = 4 * std::numbers::pi;
  EXPECT_NEAR(integral(0, 0, 0), area, 1e-13);
  EXPECT_NEAR(integral(2, 4, 4), area * (1 * 3 * 3) / (3 * 5 * 7 * 9 * 11.0), 1e-14);
  EXPECT_NEAR(integral(0, 0, 10), area / 11, 1e-14);
  EXPECT_NEAR(integral(3, 2, 4), 0, 1e-15);
  EXPECT_GT(std::fabs(integral(0, 0, 12) - area / 13), 1e-6);
}

TEST(RotationGenerators, TurnTheBasis) {
  const int degree = 5;
  const auto l = rotation_generators(degree);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
    const double e = 1e-5;
    const Eigen::VectorXd ahead = harmonics_at(Eigen::AngleAxisd(e, axis) * start, degree);
    const Eigen::VectorXd behind = harmonics_at(Eigen::AngleAxisd(-e, axis) * start, degree);
    const Eigen::VectorXd slope = l[static_cast<std::size_t>(i)].transpose() * harmonics_at(start, degree);
    EXPECT_LT(((ahead - behind) / (2 * e) - slope).cwiseAbs().maxCoeff(), 1e-8) << i;
  }
}

TEST(RotationGenerators, AreAntisymmetricWithTheRightBracketsAndCasimir) {
  const auto l = rotation_generators(30);
  sparse_matrix casimir = l[0] * l[0];
  casimir += l[1] * l[1] + sparse_matrix(l[2] * l[2]);
  for (int degree = 0; degree <= 30; ++degree)
    for (int m = -degree; m <= degree; ++m)
      casimir.coeffRef(harmonic_index(degree, m), harmonic_index(degree, m)) += degree * (degree + 1);
  EXPECT_LT(casimir.norm(), 1e-10);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    EXPECT_EQ(sparse_matrix(l[i] + sparse_matrix(l[i].transpose())).norm(), 0);
    EXPECT_LT(sparse_matrix(sparse_matrix(l[i] * l[j]) - sparse_matrix(l[j] * l[i]) + l[k]).norm(), 1e-10);
  }
}

TEST(Coordinates, MultiplyFunctions) {
  const int degree = 12;
  const auto x = coordinates(degree + 1);
  const auto f = [](const Eigen::Vector3d& p) { return std::exp(0.3 * p[0] - 0.2 * p[1] + 0.1 * p[2]); };
  const Eigen::VectorXd c = harmonic_coefficients(f, degree + 1), y = harmonics_at(start, degree + 1);
  EXPECT_NEAR(y.dot(c), f(start), 1e-13);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Eigen::VectorXd product = x[i] * (x[j] * c);
      EXPECT_NEAR(y.dot(product), start[long(i)] * start[long(j)] * f(start), 1e-13) << i << j;
    }
}

}  // namespace
}  // namespace polhode::test
