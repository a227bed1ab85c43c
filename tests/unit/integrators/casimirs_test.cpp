// SPDX-License-Identifier: Apache-2.0
// Casimirs of every algebra against their definition; projections from far, of states of nothing, and where eigenvalues
// coincide.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <numbers>

#include <polhode/lie/se2.hpp>
#include <polhode/lie/se3.hpp>
#include <polhode/lie/so3_power.hpp>
#include <polhode/lie/so4.hpp>
#include <polhode/lie/son.hpp>
#include <polhode/lie/su.hpp>

#include "support/expect_near.hpp"

namespace polhode {
namespace {

template <class Vector>
Vector some(int n, double shift = 0) {
  auto out = zeros<Vector>(n);
  for (int k = 0; k < n; ++k) out[k] = std::sin(1.7 * k + shift + 0.4);
  return out;
}
using test::expect_near;

TEST(Se2, AnElementThatDoesNotTurnShiftsAlone) {
  const vec<double, 3> mu{{0.3, -0.7, 1.1}};
  expect_near(se2::exp_action({{0, 0.5, -0.2}}, mu), {{0.3 + 0.7 * 0.2 - 1.1 * 0.5, -0.7, 1.1}}, 1e-15);
}

TEST(Se3, CasimirsAreMeasuredByTheLengthsOfWhatTheyAreOf) {
  const auto mu = some<vec<double, 6>>(6);
  const auto gamma = se3::gamma(mu);
  const double length = std::sqrt(dot(gamma, gamma));
  expect_near(se3::casimir_sizes(mu), {{length, std::sqrt(dot(mu, mu)) * length}}, 1e-15);
}

TEST(Projection, OfAStateOfNothingIsItself) {
  expect_near(so3::orbit_projection(vec<double, 3>{}, {{0.3, -0.7, 1.1}}), {}, 0);
  const vec<double, 6> pi_alone{{0.3, -0.7, 1.1, 0, 0, 0}};
  expect_near(se3::orbit_projection(pi_alone, pi_alone), pi_alone, 0);
}

TEST(Casimirs, OfAProductAreTheLengthsOfItsParts) {
  const auto length = [](double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); };
  const auto two = some<vec<double, 6>>(6);
  expect_near(so4::casimirs(two), {{length(two[0], two[1], two[2]), length(two[3], two[4], two[5])}}, 1e-15);
  for (const int parts : {1, 3, 4}) {
    const auto mu = some<so3_power<4>::element<double>>(3 * parts);
    const auto found = so3_power<4>::casimirs(mu);
    ASSERT_EQ(found.size, parts);
    for (int i = 0; i < parts; ++i)
      EXPECT_NEAR(found[i], length(mu[3 * i], mu[3 * i + 1], mu[3 * i + 2]), 1e-15) << parts << ' ' << i;
  }
}

TEST(Casimirs, OfSkewMatricesAreTracesOfEvenPowers) {
  for (int n = 3; n <= 6; ++n) {
    const int components = n * (n - 1) / 2;
    EXPECT_EQ(son::rows_of(components), n);
    const auto mu = some<son::element<double>>(components);
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    int place = 0;
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j) m(i, j) = mu[place++];
    m -= m.transpose().eval();
    const Eigen::MatrixXd square = m.transpose() * m;
    const auto found = son::casimirs(mu);
    ASSERT_EQ(found.size, n / 2);
    EXPECT_NEAR(found[0], std::sqrt(dot(mu, mu)), 1e-14);
    Eigen::MatrixXd power = square;
    for (int k = 1; k < n / 2; ++k) {
      power *= square;
      EXPECT_NEAR(found[k], power.trace() / 2, 1e-14 * power.trace()) << n << ' ' << k;
    }
  }
}

/// H = sum_k v_k J_k entry by entry: (J_k)_ab = exp(2 pi i k_1 (a + b) / n) at b = a + k_2.
Eigen::MatrixXcd hermitian_of(const su::element<double>& v) {
  const int n = v.size == 8 ? 3 : 5;
  Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(n, n);
  int place = 0;
  for (int k1 = 0; k1 <= n / 2; ++k1)
    for (int k2 = k1 == 0 ? 1 : -(n / 2); k2 <= n / 2; ++k2, place += 2)
      for (int a = 0; a < n; ++a) {
        const int b = (a + k2 + n) % n;
        out(a, b) += std::complex(v[place], v[place + 1]) / std::numbers::sqrt2 *
                     std::polar(1.0, 2 * std::numbers::pi * k1 * (a + b) / n);
      }
  return out + out.adjoint().eval();
}
double trace_of_power(const Eigen::MatrixXcd& h, int power) {
  Eigen::MatrixXcd out = h;
  for (int j = 1; j < power; ++j) out *= h;
  return out.trace().real() / static_cast<double>(h.rows());
}

TEST(Casimirs, OfHermitianMatricesAreTracesOfPowersAndMeasuredByEvenOnes) {
  for (const int n : {3, 5}) {
    const auto mu = some<su::element<double>>(n * n - 1);
    const auto h = hermitian_of(mu);
    const auto found = su::casimirs(mu), sizes = su::casimir_sizes(mu);
    ASSERT_EQ(found.size, n - 1);
    ASSERT_EQ(sizes.size, n - 1);
    for (int j = 2; j <= n; ++j) {
      const double trace = trace_of_power(h, j),
                   size = j % 2 == 0 ? trace : std::sqrt(trace_of_power(h, j - 1) * trace_of_power(h, j + 1));
      EXPECT_NEAR(found[j - 2], j == 2 ? std::sqrt(trace) : trace, 1e-13 * size) << n << ' ' << j;
      EXPECT_NEAR(sizes[j - 2], j == 2 ? std::sqrt(trace) : size, 1e-13 * size) << n << ' ' << j;
    }
  }
}

// Roots of unity are rounded, by the same at every time: what that leaves of one return would add up.
TEST(Su, ModesComeBackFromTheirMatrixManyTimes) {
  const auto mu = some<su::element<double>>(24);
  auto now = mu;
  for (int i = 0; i < 20'000; ++i) now = su::modes_of(su::hermitian<5>(now));
  double most = 0;
  for (int k = 0; k < 24; ++k) most = std::max(most, std::fabs(now[k] - mu[k]));
  EXPECT_LE(most, 1e-14);
}

// Each correction about squares what is left: of five, the last is the first to leave rounding alone.
TEST(Su, ProjectsFromFar) {
  const auto onto = some<su::element<double>>(8);
  const auto found = su::casimirs(su::orbit_projection(1.7 * onto, onto)), expected = su::casimirs(onto);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(found[k], expected[k], 1e-14 * su::casimir_sizes(onto)[k]) << k;
}

/// A diagonal H of three rows with trace zero, |mu| = 1 and tr H^3 / 3 = cos(3 phi) / sqrt(2).
su::element<double> diagonal(double phi) {
  complex_matrix<double, 3> h;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      h(i, j) = {i == j ? std::numbers::sqrt2 * std::cos(phi + 2 * std::numbers::pi * i / 3) : 0, 0};
  return su::modes_of(h);
}

TEST(Su, WhereEigenvaluesCoincideTheLengthAloneIsPutRight) {
  const auto two_alike = 0.7 * diagonal(0);
  const auto onto = diagonal(0.3);
  expect_near(su::orbit_projection(two_alike, onto), diagonal(0), 1e-13);
}

// Of what is of the right length, and asked for another tr H^3 alone, Newton's first c are those of tr H^3: tr H^3 is
// asked for such that their sizes add up to a little less than ten, or a little more.
TEST(Su, TakesNoCorrectionOfMoreThanTen) {
  const double phi = 0.1;
  Eigen::Matrix3d slopes;
  double traces[5];
  for (int j = 0; j < 5; ++j) {
    traces[j] = 0;
    for (int i = 0; i < 3; ++i)
      traces[j] += std::pow(std::numbers::sqrt2 * std::cos(phi + 2 * std::numbers::pi * i / 3), j) / 3;
  }
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k) slopes(j, k) = traces[j + k];
  // The last column of the inverse, by cofactors.
  const Eigen::RowVector3d across = slopes.row(0).cross(slopes.row(1)), column = across / across.dot(slopes.row(2));
  for (const double size : {9.9995, 10.005}) {
    const double cubes = traces[3] - 3 * size / column.lpNorm<1>();
    const auto mu = diagonal(phi), onto = diagonal(std::acos(std::numbers::sqrt2 * cubes) / 3);
    const auto found = su::orbit_projection(mu, onto);
    const double moved = std::sqrt(dot(found - mu, found - mu));
    if (size < 10)
      EXPECT_GT(moved, 1e-3);
    else
      EXPECT_LT(moved, 1e-13);
  }
}

}  // namespace
}  // namespace polhode
