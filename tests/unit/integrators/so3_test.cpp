// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <polhode/simd.hpp>

#include "systems/rigid_body/motion/body_parts.hpp"

#include "support/dense.hpp"
#include "support/schemes.hpp"

namespace polhode::test {
namespace {

using column = vec<double, 3>;

column some_vector(std::uint64_t i, double length) {
  auto v = normals<3>({11, noise_kind::initial_state, i, 0});
  return (length / std::sqrt(dot(v, v))) * v;
}

Eigen::Matrix3d coad_matrix(const column& xi) {
  Eigen::Matrix3d m;
  for (int k = 0; k < 3; ++k) {
    column e{};
    e[k] = 1;
    const auto image = so3::coad(xi, e);
    for (int row = 0; row < 3; ++row) m(row, k) = image[row];
  }
  return m;
}

double distance_to(const column& a, const Eigen::Vector3d& b) { return (Eigen::Vector3d(a.c.data()) - b).norm(); }

struct Angles : testing::TestWithParam<double> {};

TEST_P(Angles, ExponentialActionIsTheMatrixExponential) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto xi = some_vector(i, GetParam());
    const Eigen::Vector3d expected = test::exponential_of(coad_matrix(xi)) * Eigen::Vector3d(paper_momentum.c.data());
    EXPECT_LE(distance_to(so3::exp_action(xi, paper_momentum), expected), 1e-14 * std::max(1.0, GetParam()));
  }
}

TEST_P(Angles, CayleyActionIsTheCayleyTransform) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto xi = some_vector(i, GetParam());
    const Eigen::Matrix3d half = 0.5 * coad_matrix(xi), one = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d expected = (one - half).inverse() * (one + half) * Eigen::Vector3d(paper_momentum.c.data());
    EXPECT_LE(distance_to(so3::cayley_action(xi, paper_momentum), expected), 1e-14 * std::max(1.0, GetParam()));
  }
}

TEST_P(Angles, ActionsKeepTheLength) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    const auto xi = some_vector(i, GetParam());
    EXPECT_NEAR(so3::casimirs(so3::exp_action(xi, paper_momentum))[0], 1.0, 1e-15);
    EXPECT_NEAR(so3::casimirs(so3::cayley_action(xi, paper_momentum))[0], 1.0, 1e-15);
  }
}

INSTANTIATE_TEST_SUITE_P(FromZeroToHuge, Angles,
                         testing::Values(0.0, 1e-300, 1e-12, 1e-6, 1e-3, 0.2, 1.0, 3.0, 10.0, 300.0));

TEST(So3, ExponentialOfHugeAnglesIsARotation) {
  for (const double angle : {1e4, 1e6, 1e9, 1e12})
    EXPECT_NEAR(so3::casimirs(so3::exp_action(some_vector(1, angle), paper_momentum))[0], 1.0, 1e-15) << angle;
}

TEST(So3, RotationIsByMinusXi) {
  const double quarter = std::acos(0.0);
  const auto turned = so3::exp_action(column{{0, 0, quarter}}, column{{1, 0, 0}});
  EXPECT_LE(distance(turned, column{{0, -1, 0}}), 1e-15);
}

TEST(So3, BracketIsTheCommutatorOfCoadjointOperatorsInItsOrder) {
  const auto x = some_vector(1, 0.7), y = some_vector(2, 1.3), mu = paper_momentum;
  const auto commutator = so3::coad(y, so3::coad(x, mu)) - so3::coad(x, so3::coad(y, mu));
  EXPECT_LE(distance(commutator, so3::coad(so3::bracket(x, y), mu)), 1e-15);
}

/// d/dt exp(C(u + t w)) at t = 0 equals C(v) exp(C(u)) where w = dexp_inv(-u, v).
TEST(So3, DexpInvInvertsTheDifferentialOfTheAction) {
  for (const double size : {1e-9, 1e-3, 0.1, 0.19, 0.21, 1.0, 3.0, 5.0}) {
    const auto u = some_vector(3, size), v = some_vector(4, 1.0);
    const auto w = so3::dexp_inv(-u, v);
    constexpr double h = 1e-4;
    const auto slope =
        (1 / (12 * h)) *
        (8.0 * (so3::exp_action(u + h * w, paper_momentum) - so3::exp_action(u - h * w, paper_momentum)) -
         (so3::exp_action(u + (2 * h) * w, paper_momentum) - so3::exp_action(u - (2 * h) * w, paper_momentum)));
    EXPECT_LE(distance(slope, so3::coad(v, so3::exp_action(u, paper_momentum))), 1e-10) << size;
  }
}

TEST(So3, DexpInvHasNoSeamBetweenSeriesAndClosedForm) {
  const auto v = some_vector(5, 1.0);
  for (const double size : {0.2 - 1e-9, 0.2 + 1e-9}) {
    const auto u = some_vector(6, size);
    vec<double, 3> sum = v, term = v;  // sum of B_k/k! ad^k v
    const double b[] = {-0.5, 1.0 / 12, 0, -1.0 / 720, 0, 1.0 / 30240, 0, -1.0 / 1209600, 0, 1.0 / 47900160};
    for (const double coefficient : b) {
      term = so3::bracket(u, term);
      sum = sum + coefficient * term;
    }
    EXPECT_LE(distance(so3::dexp_inv(u, v), sum), 1e-15);
  }
}

/// What a series leaves out has one sign, and a million steps add it up: 7 / 256 excess^5 would be 3e-11 of them.
TEST(So3, AProjectionLeavesNothingOut) {
  for (const long double excess : {-9.99e-4L, -5e-4L, 5e-4L, 9.99e-4L, 2e-3L, 0.5L}) {
    const vec<long double, 3> onto{{0.6L, 0.48L, 0.64L}};
    const auto there = so3::orbit_projection((1 / std::sqrt(1 + excess)) * onto, onto);
    EXPECT_NEAR(static_cast<double>(std::sqrt(dot(there, there) / dot(onto, onto)) - 1), 0, 4e-19);
  }
}

template <int degree, double reach>
rotation_series<degree, reach> series_of(so3_near<degree, reach>);

/// By how much a rotation with these polynomials changes the square of a length, at most, beyond what the rounding of
/// their coefficients and long double allow.
template <rotation_size size>
double excess_of_length() {
  using series = decltype(series_of(typename rotations<size>::algebra{}));
  const auto exactly = [](const auto& p, long double q) {
    long double sum = 0;
    for (std::size_t k = p.size(); k-- > 0;) sum = sum * q + p[k];
    return sum;
  };
  long double worst = -1;
  for (int i = 0; i <= 1000; ++i) {
    const long double angle = rotations<size>::bounds.generator * i / 1000, q = angle * angle;
    const long double f = exactly(series::sinc, q), s = 1 - q * exactly(series::cosc, q);
    worst = std::max(worst, std::fabs(s * s + q * f * f - 1) - (3e-19L + 1e-17L * q * q));
  }
  return static_cast<double>(worst);
}

// What a polynomial leaves has one sign, step after step: in ten million of them 1e-17 would become 1e-10.
TEST(So3Near, LengthsDoNotDrift) {
  EXPECT_LE(excess_of_length<rotation_size::small>(), 0);
  EXPECT_LE(excess_of_length<rotation_size::moderate>(), 0);
}

TEST(Scalar, ARoundedProductIsTheProduct) {
  using wide = stdx::fixed_size_simd<double, static_cast<int>(2 * pack::size())>;
  EXPECT_EQ(rounded_product(0.1 * 3), 0.1 * 3);
  EXPECT_TRUE(all_of(rounded_product(pack([](auto i) { return 0.1 * i; })) == pack([](auto i) { return 0.1 * i; })));
  EXPECT_TRUE(all_of(rounded_product(wide([](auto i) { return 0.1 * i; })) == wide([](auto i) { return 0.1 * i; })));
}

TEST(Scalar, ALaneDoesNotSeeItsNeighbours) {
  if (pack::size() < 2) GTEST_SKIP() << "one lane";
  const pack near_and_far([](auto lane) { return lane == 0 ? 0.7 : 1e9; });
  EXPECT_EQ(sincos(near_and_far).sin[0], sincos(pack(0.7)).sin[0]);
}

}  // namespace
}  // namespace polhode::test
