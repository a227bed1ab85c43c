// SPDX-License-Identifier: Apache-2.0
// The averaged gap against integrals along the circles, point by point, where ours are elliptic.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>

#include "algebra/decompositions.hpp"
#include "sphere/averaged_gap.hpp"

namespace polhode {
namespace {

using Eigen::Vector3d;

/// A rigid body with inverse inertia k on the sphere of radius r: h = k.x^2 / 2; noise Q = diag(q).
struct principal_body {
  Vector3d k, q;
  double radius, beta;
};

/// Circles about an axis as far as those through the middle one.
struct family {
  const principal_body& of;
  int axis, middle, other;
  double apart(int i) const { return std::fabs(of.k[i] - of.k[axis]); }
  double length() const { return apart(middle) * of.radius * of.radius / 2; }

  struct averages {
    double noise = 0, period = 0;  ///< sum Q_ii J_i / 2, and T
  };
  /// At an energy of (1 - t^2) length beside that of the axis: x_middle, x_other on an ellipse.
  averages at(double t) const {
    const double r = of.radius, y = (1 - t * t) * length();
    averages out;
    const auto integral = [&](auto value) {
      return 4 * boost::math::quadrature::tanh_sinh<double>().integrate(
                     [&](double phi) {
                       Vector3d x;
                       x[middle] = std::sqrt(2 * y / apart(middle)) * std::cos(phi);
                       x[other] = std::sqrt(2 * y / apart(other)) * std::sin(phi);
                       x[axis] = std::sqrt(std::pow(r * t * std::cos(phi), 2) +
                                           std::pow(std::sin(phi), 2) * (r * r - 2 * y / apart(other)));
                       return value(x) / (x[axis] * std::sqrt(apart(middle) * apart(other)));
                     },
                     0.0, std::numbers::pi / 2, 1e-12);
    };
    out.period = integral([](const Vector3d&) { return 1.0; });
    out.noise = integral([&](const Vector3d& x) { return of.q.dot(x.cross(of.k.cwiseProduct(x)).cwiseAbs2()) / 2; });
    return out;
  }
};

constexpr int powers = 26;

/// Forms of the polynomials (1 - s) P_k(2 s - 1) and of 1, with s = 1 - t, over energies of a family.
void add_forms(const family& f, Eigen::MatrixXd& stiffness, Eigen::MatrixXd& mass) {
  using rule = boost::math::quadrature::gauss<double, 120>;
  const double sign = f.of.k[f.middle] > f.of.k[f.axis] ? 1 : -1;
  stiffness = mass = Eigen::MatrixXd::Zero(powers + 1, powers + 1);
  for (std::size_t n = 0; n < rule::abscissa().size(); ++n)
    for (const double x : {rule::abscissa()[n], -rule::abscissa()[n]}) {
      const double weight = rule::weights()[n] / 2, t = (1 - x) / 2, slope = 2 * t * f.length();  // dy/ds
      const auto a = f.at(t);
      const double density = std::exp(f.of.beta * sign * t * t * f.length());  // over that at the middle axis
      Eigen::VectorXd u(powers + 1), du(powers + 1);
      for (int k = 0; k < powers; ++k) {
        u[k] = t * boost::math::legendre_p(k, x);
        du[k] = 2 * t * (k > 0 ? boost::math::legendre_p_prime(k, x) : 0) - boost::math::legendre_p(k, x);
      }
      u[powers] = 1;
      du[powers] = 0;
      stiffness += weight * density * a.noise / slope * du * du.transpose();
      mass += weight * density * a.period * slope * u * u.transpose();
    }
}

averaged_rates along_the_circles(const principal_body& b, int least, int middle, int most) {
  Eigen::MatrixXd k1, m1, k2, m2;
  add_forms({b, least, middle, most}, k1, m1);
  add_forms({b, most, middle, least}, k2, m2);
  const auto odd = [](const Eigen::MatrixXd& k, const Eigen::MatrixXd& m) {
    return generalised_eigenvalues_of(k.topLeftCorner(powers, powers), m.topLeftCorner(powers, powers))[0];
  };
  // Joined at the vertex, where the last function of both is the same.
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(2 * powers + 1, 2 * powers + 1), m = k;
  k.topLeftCorner(powers + 1, powers + 1) = k1;
  m.topLeftCorner(powers + 1, powers + 1) = m1;
  Eigen::VectorXi second = Eigen::VectorXi::LinSpaced(powers + 1, powers + 1, 2 * powers + 1);
  second[powers] = powers;
  k(second, second) += k2;
  m(second, second) += m2;
  return {std::min(odd(k1, m1), odd(k2, m2)), generalised_eigenvalues_of(k, m)[1]};
}

void expect_alike(const principal_body& b, double theta, int least, int middle, int most, double within = 1e-6) {
  const Vector3d inertia = b.k.cwiseInverse();
  const auto found = averaged_gap(
      body_on_sphere({inertia[0], inertia[1], inertia[2]}, theta, b.radius, Eigen::Matrix3d(b.q.asDiagonal())));
  const auto expected = along_the_circles(b, least, middle, most);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->odd, expected.odd, within * expected.odd);
  EXPECT_NEAR(found->even, expected.even, within * expected.even);
  EXPECT_EQ(found->gap(), std::min(found->odd, found->even));
}

TEST(AveragedGap, IsThatOfIntegralsAlongTheCirclesUnderAnyNoise) {
  for (const Vector3d& q : {Vector3d(1, 1, 1), Vector3d(0.3, 1, 2), Vector3d(2, 0.1, 0.4)})
    for (const double radius : {1.0, 1.7}) expect_alike({{1, 0.5, 1 / 3.0}, q, radius, 0}, 0, 2, 1, 0);
}

TEST(AveragedGap, IsThatOfIntegralsAlongTheCirclesOfNearlyRoundBodies) {
  expect_alike({{1, 1 / 1.001, 0.2}, {0.3, 1, 2}, 1, 0}, 0, 2, 1, 0, 4e-6);
  expect_alike({{0.2, 1, 1 / 1.001}, {0.3, 1, 2}, 1, 0}, 0, 0, 2, 1, 4e-6);
}

// beta = 2 theta / sigma^2, either side of the middle axis.
TEST(AveragedGap, IsThatOfIntegralsAlongTheCirclesUnderDissipation) {
  for (const double theta : {0.1, 1.5})
    expect_alike({{1, 0.5, 1 / 3.0}, {0.5, 0.5, 0.5}, 1.2, 2 * theta / 0.5}, theta, 2, 1, 0);
}

// Noise about every principal axis, no dissipation but under isotropic noise, a body that is no sphere, and a law that
// is not narrower than exp(300).
TEST(AveragedGap, OfWhatItIsNotMadeForIsNone) {
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const auto body = [&](double theta, const Vector3d& q, double c = 1) {
    return body_on_sphere({1, 2, 3}, theta, c, Eigen::Matrix3d(q.asDiagonal()));
  };
  EXPECT_TRUE(averaged_gap(body(0, {1, 2, 3})));
  EXPECT_FALSE(averaged_gap(body(0, {1, 2, 0})));
  EXPECT_TRUE(averaged_gap(body(0.1, {1, 1, 1})));
  EXPECT_FALSE(averaged_gap(body(0.1, {1, 2, 3})));
  EXPECT_FALSE(averaged_gap(body_on_sphere({2, 2, 2}, 0, 1, one)));
  auto bent = body(0, {1, 1, 1});
  bent.quadratic(0, 1) = bent.quadratic(1, 0) = 0.01;
  EXPECT_FALSE(averaged_gap(bent));
  auto in_field = body(0, {1, 1, 1});
  in_field.field = {0.1, 0, 0};
  EXPECT_FALSE(averaged_gap(in_field));
  auto crossed = body(0, {1, 1, 1});
  crossed.covariance(0, 1) = crossed.covariance(1, 0) = 0.1;
  EXPECT_TRUE(averaged_gap(crossed));
  // From the middle axis to the one of greatest energy h rises by c^2 / 4: of beta = 2 theta / sigma^2, c = 3.
  EXPECT_TRUE(averaged_gap(body(0.5 * 295 / 2.25, {1, 1, 1}, 3)));
  EXPECT_FALSE(averaged_gap(body(0.5 * 305 / 2.25, {1, 1, 1}, 3)));
}

}  // namespace
}  // namespace polhode
