// SPDX-License-Identifier: Apache-2.0
// Where h is stationary on the sphere: closed forms, and topology on problems drawn at random.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/closed_forms/linearised.hpp"
#include "sphere/equilibria.hpp"

namespace polhode::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

sphere_problem drawn(std::mt19937& bits, double field) {
  std::normal_distribution<double> normal;
  const auto any = [&] { return normal(bits); };
  const Matrix3d a = Matrix3d::NullaryExpr(any);
  return {.quadratic = a + a.transpose(),
          .damping = 0.5,
          .radius = std::exp(any()),
          .covariance = Matrix3d::Identity(),
          .field = field * Vector3d(Vector3d::NullaryExpr(any))};
}

// Pi x Omega = 0; wells less passes plus peaks is the Euler characteristic of the sphere.
TEST(Equilibria, AreAllThereAre) {
  std::mt19937 bits(7);
  for (const double field : {0.0, 0.01, 0.3, 1.0, 3.0, 100.0})
    for (int i = 0; i < 200; ++i) {
      const auto p = drawn(bits, field);
      int characteristic = 0;
      const auto all = equilibria(p);
      for (const auto& e : all) {
        const Vector3d pi = p.radius * e.direction;
        EXPECT_LE(pi.cross(p.rate(pi)).norm(), 1e-10 * p.radius * greatest_rate_on(p)) << field << ' ' << i;
        EXPECT_NEAR(e.energy, p.energy(pi), 1e-14 * greatest_energy_on(p));
        characteristic += e.curvature[0] * e.curvature[1] > 0 ? 1 : -1;
      }
      EXPECT_EQ(characteristic, 2) << field << ' ' << i << ": " << all.size();
      EXPECT_TRUE(std::ranges::is_sorted(all, {}, &equilibrium::energy));
      EXPECT_TRUE(all.front().is_least());
    }
}

// Eigenvectors of h, right-handed.
TEST(PrincipalAxes, AreARotation) {
  std::mt19937 bits(3);
  for (int i = 0; i < 50; ++i) {
    const auto p = drawn(bits, 0);
    const Matrix3d axes = principal_axes(p), diagonal = axes.transpose() * p.quadratic * axes;
    EXPECT_NEAR(axes.determinant(), 1, 1e-13);
    EXPECT_LT((axes.transpose() * axes - Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_LT((diagonal - Matrix3d(diagonal.diagonal().asDiagonal())).norm(), 1e-13 * p.quadratic.norm());
  }
  EXPECT_EQ(principal_axes({Vector3d(3, 1, 2).asDiagonal(), 0, 1, Matrix3d::Identity()}),
            Matrix3d(Matrix3d::Identity()));
}

TEST(TangentFrame, IsRightHandedAndBeginsWithTheNextAxis) {
  for (Eigen::Index k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0}) {
      const auto frame = tangent_frame(sign * Vector3d::Unit(k));
      EXPECT_EQ(Vector3d(frame.col(0)), Vector3d(Vector3d::Unit((k + 1) % 3)));
      EXPECT_EQ(Vector3d(frame.col(1)), Vector3d(sign * Vector3d::Unit((k + 2) % 3)));
    }
  const Vector3d n = Vector3d(0.6, 0.64, 0.48).normalized();
  const auto frame = tangent_frame(n);
  EXPECT_NEAR(frame.col(0).cross(frame.col(1)).dot(n), 1, 1e-15);
}

// A curvature that is rounding of the others, or of the field over |Pi|, is none; h and |Pi| in any unit.
TEST(Equilibria, ARingHasNoCurvatureAlongItself) {
  for (const double unit : {1e-6, 1.0, 1e6})
    for (const double radius : {1e-3, 1.0, 1e3})
      for (const double tilt : {0.0, 0.3, 1.2}) {
        const Matrix3d r = Eigen::AngleAxisd(tilt, Vector3d(1, 2, 2) / 3).toRotationMatrix();
        const sphere_problem p{unit * (r * Vector3d(0, 0, -2).asDiagonal() * r.transpose()), 0.5, radius,
                               Matrix3d::Identity(), unit * radius * 1.2 * (r * Vector3d::UnitZ())};
        int rings = 0;
        for (const auto& e : equilibria(p))
          if (e.curvature.cwiseAbs().minCoeff() == 0) ++rings;
        EXPECT_GT(rings, 0) << unit << ' ' << radius << ' ' << tilt;
      }
  const sphere_problem faint{Vector3d(1, 1 + 1e-9, 2).asDiagonal(), 0.5, 1, Matrix3d::Identity()};
  for (const auto& e : equilibria(faint)) EXPECT_GT(e.curvature.cwiseAbs().minCoeff(), 1e-10);
}

TEST(Equilibria, OfABodyAreItsAxes) {
  const auto p = body_on_sphere({1, 2, 3}, 0.5, 2, Matrix3d::Identity());
  const auto all = equilibria(p);
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto axis = static_cast<Eigen::Index>(2 - i / 2);
    EXPECT_EQ(all[i].direction, (i % 2 == 0 ? 1 : -1) * Vector3d::Unit(axis));
    EXPECT_DOUBLE_EQ(all[i].energy, 2.0 / static_cast<double>(axis + 1));
  }
  EXPECT_DOUBLE_EQ(barrier_between_wells(p), 1.0 - 2.0 / 3);
}

// Stoner and Wohlfarth's particle: h = -k z^2/2 + b z has wells at z = -1 and 1 and a ring of passes at z = b/k; from
// the upper well (k - b)^2/2k is to be climbed. Beyond b = k one well is left.
TEST(Equilibria, OfAUniaxialSpinInAField) {
  const auto spin = [](double k, double b) {
    return sphere_problem{.quadratic = Vector3d(0, 0, -k).asDiagonal(),
                          .damping = 0.5,
                          .radius = 1,
                          .covariance = Matrix3d::Identity(),
                          .field = Vector3d(0, 0, b)};
  };
  for (const double b : {0.0, 0.1, 0.7, 1.9}) {
    EXPECT_NEAR(barrier_between_wells(spin(2, b)), (2 - b) * (2 - b) / 4, 1e-14) << b;
    EXPECT_NEAR(equilibria(spin(2, b)).back().energy, b * b / 4, 1e-14) << b;
  }
  EXPECT_EQ(barrier_between_wells(spin(2, 2.1)), 0);
  EXPECT_EQ(equilibria(spin(2, 2.1)).size(), 2u);
  EXPECT_EQ(barrier_between_wells(spin(-2, 0.3)), 0);  // an easy plane: a ring of wells
}

// A well that a thousandth of the anisotropy keeps.
TEST(Equilibria, AFaintBarrierIsStillOne) {
  const sphere_problem spin{Vector3d(0, 0, -2).asDiagonal(), 0.5, 1, Matrix3d::Identity(), Vector3d(0, 0, 1.99)};
  EXPECT_NEAR(barrier_between_wells(spin), 0.01 * 0.01 / 4, 1e-15);
}

// All six of a body stay in a weak field.
TEST(Equilibria, AWeakFieldMovesThemAndTakesNone) {
  std::mt19937 bits(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20; ++i) {
    const Matrix3d r =
        Eigen::AngleAxisd(normal(bits), Vector3d(Vector3d::NullaryExpr([&] { return normal(bits); })).normalized())
            .toRotationMatrix();
    const Vector3d field = 0.05 * Vector3d(Vector3d::NullaryExpr([&] { return normal(bits); }));
    EXPECT_EQ(
        equilibria({r * Vector3d(1, 2, 4).asDiagonal() * r.transpose(), 0.5, 1.3, Matrix3d::Identity(), field}).size(),
        6U)
        << i;
  }
}

// Stoner and Wohlfarth's astroid: |b_x|^(2/3) + |b_z|^(2/3) = (k |Pi|)^(2/3), within it four, outside it two.
TEST(Equilibria, OfAUniaxialSpinAreFourWithinTheAstroid) {
  const double k = 0.8, radius = 1.3;
  const auto count = [=](double psi, double share) {
    const double c = std::cos(psi), s = std::sin(psi), b = share * k * radius;
    return equilibria({Vector3d(0, 0, -k).asDiagonal(), 0.5, radius, Matrix3d::Identity(),
                       b * Vector3d(c * c * c, 0, s * s * s)})
        .size();
  };
  for (int i = 1; i < 40; ++i) {
    const double psi = i * std::numbers::pi / 80;
    for (const double within : {0.1, 0.4, 0.7, 0.9, 0.99}) EXPECT_EQ(count(psi, within), 4U) << i << ' ' << within;
    EXPECT_EQ(count(psi, 1.01), 2U) << i;
  }
}

TEST(Equilibria, OfAFaintFieldAloneAreItsTwoPoles) {
  const Vector3d n = Vector3d(1, -2, 2) / 3;
  const auto all = equilibria({Matrix3d::Zero(), 0.5, 2, Matrix3d::Identity(), 1e-9 * n});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_LT((all[0].direction + n).norm(), 1e-15);
  EXPECT_LT((all[1].direction - n).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(all[0].energy, -2e-9);
}

// At the field at which it ends the upper well is flat; of a curvature that is small but there, something is left.
TEST(Equilibria, AreFlatWhereAWellEndsAndOnlyThere) {
  for (const double radius : {1e-3, 1.0, 1e3})
    for (const double tilt : {0.3, 0.7, 1.2}) {
      const Matrix3d r = Eigen::AngleAxisd(tilt, Vector3d(1, 2, 2) / 3).toRotationMatrix();
      const auto at = [&](double share) {
        return equilibria({r * Vector3d(0, 0, -2).asDiagonal() * r.transpose(), 0.5, radius, Matrix3d::Identity(),
                           2 * share * radius * (r * Vector3d::UnitZ())})
            .back();
      };
      EXPECT_EQ(at(1).curvature.cwiseAbs().maxCoeff(), 0) << radius << ' ' << tilt;
      EXPECT_NEAR(at(1 + 1e-9).curvature[0], -2e-9, 1e-14) << radius << ' ' << tilt;
    }
}

// The drift's own derivative, by differences.
TEST(Equilibria, TheLinearisedEquationIsTheDriftsDerivative) {
  std::mt19937 bits(11);
  for (int i = 0; i < 50; ++i) {
    const auto p = drawn(bits, 0.5);
    const auto drift = [&](const Vector3d& pi) -> Vector3d {
      const Vector3d w = p.rate(pi);
      return pi.cross(w + p.damping * pi.cross(w));
    };
    const auto all = equilibria(p);
    ASSERT_FALSE(all.empty());
    for (const auto& e : all) {
      const auto frame = tangent_frame(e.direction);
      Eigen::Matrix2d slope;
      const double step = 1e-5 * p.radius;
      for (int k = 0; k < 2; ++k) {
        const Vector3d pi = p.radius * e.direction, d = step * frame.col(k);
        slope.col(k) = frame.transpose() * (drift(pi + d) - drift(pi - d)) / (2 * step);
      }
      const auto exact = linearised_about(p, e.direction, 0).drift;
      EXPECT_LE((slope - exact).norm(), 1e-6 * (1 + exact.norm())) << i;
    }
  }
}

// The law that sums over the sphere against the body's closed form.
TEST(Gibbs, ByQuadratureIsTheClosedForm) {
  for (const double beta : {0.5, 4.0, 60.0}) {
    const gibbs_law exact({1, 2, 3}, 1.2, beta);
    const auto found = gibbs_law::by_quadrature(body_on_sphere({1, 2, 3}, beta / 2, 1.2, Matrix3d::Identity()));
    EXPECT_NEAR(found.mean_energy(), exact.mean_energy(), 1e-12);
    EXPECT_NEAR(found.energy_variance(), exact.energy_variance(), 1e-12);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.mean_square(k), exact.mean_square(k), 1e-12);
    double worst = 0;
    for (int i = 1; i < 200; ++i) {
      const double h = std::lerp(exact.least_energy(), exact.greatest_energy(), i / 200.0);
      worst = std::max(worst, std::fabs(found.energy_cdf(h) - exact.energy_cdf(h)));
    }
    EXPECT_LT(worst, 2e-3) << beta;
  }
}

// A field alone: h = b c z with z of density exp(-x z), x = beta b c (Langevin).
TEST(Gibbs, InAFieldAloneIsLangevins) {
  const double theta = 0.4, sigma2 = 0.36, b = 0.7, c = 1.5, x = 2 * theta / sigma2 * b * c;
  const auto law = gibbs_law::by_quadrature({.quadratic = Matrix3d::Zero(),
                                             .damping = theta,
                                             .radius = c,
                                             .covariance = sigma2 * Matrix3d::Identity(),
                                             .field = Vector3d(0, 0, b)});
  EXPECT_NEAR(law.mean_energy(), b * c * (1 / x - 1 / std::tanh(x)), 1e-12);
  for (const double z : {-0.9, -0.3, 0.4})
    EXPECT_NEAR(law.energy_cdf(b * c * z), std::expm1(-x * (z + 1)) / std::expm1(-2 * x), 2e-3);
}

TEST(Equilibria, ARingOfLeastEnergyIsLeast) {
  EXPECT_TRUE((equilibrium{{0, 0, 1}, 0, {0, 2}}.is_least()));
  EXPECT_FALSE((equilibrium{{0, 0, 1}, 0, {-1, 2}}.is_least()));
}

}  // namespace
}  // namespace polhode::test
