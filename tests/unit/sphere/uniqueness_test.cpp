// SPDX-License-Identifier: Apache-2.0
// Laws that are not unique, by the directions of noise, field and body: in any unit, off the axes, at the limits.
#include "sphere/uniqueness.hpp"

#include <gtest/gtest.h>

#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
const Vector3d oblique = Vector3d(1, 2, -3.5).normalized();

std::string law_of_noise_along(const Vector3d& axis, const Matrix3d& quadratic, double damping, const Vector3d& field) {
  return no_unique_law({quadratic, damping, 1, axis * axis.transpose(), field});
}

// An oblique axis, of whose rounding no unit of time must make more.
TEST(Uniqueness, IsTheSameInEveryUnitOfTime) {
  const Matrix3d along = oblique * oblique.transpose();
  const Vector3d across = oblique.unitOrthogonal();
  for (const double unit : {1e-9, 1.0, 1e9}) {
    const Matrix3d top = unit * (one + 2 * along);
    EXPECT_TRUE(conserves_a_component({top, 0, 1, along, 0.3 * unit * oblique})) << unit;
    EXPECT_FALSE(conserves_a_component({top, 0, 1, along, 0.3 * unit * across})) << unit;
    EXPECT_FALSE(conserves_a_component({top + unit * across * across.transpose(), 0, 1, along})) << unit;
    EXPECT_NE(law_of_noise_along(oblique, top, 0.1, 0.3 * unit * oblique).find("equilibrium"), std::string::npos);
    EXPECT_EQ(law_of_noise_along(oblique, top, 0.1, 0.3 * unit * across), "") << unit;
  }
}

TEST(Uniqueness, ARoundBodyKeepsTheComponentAlongItsNoise) {
  const Matrix3d along = oblique * oblique.transpose();
  EXPECT_TRUE(conserves_a_component({2 * one, 0.5, 1, along}));  // at rest, damped or not
  EXPECT_TRUE(conserves_a_component({2 * one, 0, 1, along}));
  const Vector3d axis = Vector3d::UnitY();
  EXPECT_TRUE(conserves_a_component({2 * one, 0, 1, axis * axis.transpose(), 0.3 * axis}));  // it turns about the noise
  EXPECT_FALSE(conserves_a_component({2 * one, 0.5, 1, axis * axis.transpose(), 0.3 * axis}));
}

// A second direction of 1e-14 of the first is taken for rounding, no noise for noise about any axis.
TEST(Uniqueness, OneAxisIsOneUpToRounding) {
  const auto reason = [](double second) {
    return no_unique_law({Vector3d(1, 2, 3).asDiagonal(), 0.5, 1, Vector3d(0, second, 1).asDiagonal()});
  };
  EXPECT_NE(reason(1e-14), "");
  EXPECT_EQ(reason(1.1e-14), "");
  EXPECT_NE(no_unique_law({Vector3d(1, 2, 3).asDiagonal(), 0.5, 1, Matrix3d::Zero()}), "");
}

// x = (2, 1, 2) is an equilibrium and -x is none; u (1 - x.Pi / 9) vanishes at x, and u (1 + x.Pi / 9) at -x.
TEST(Uniqueness, NoiseMustVanishAtTheEquilibriumItself) {
  const Vector3d x(2, 1, 2), u(0.3, 0.5, -0.2);
  const Matrix3d quadratic = Vector3d(1, 2, 3).asDiagonal();
  sphere_problem p{quadratic, 0.2, 3, Matrix3d::Zero(), 0.5 * x - quadratic * x};
  p.varying = {{u, -u * x.transpose() / 9}};
  EXPECT_NE(no_unique_law(p).find("all noise vanishes"), std::string::npos);
  p.varying = {{u, u * x.transpose() / 9}};
  EXPECT_EQ(no_unique_law(p), "");
}

// Noise along Pi moves nothing: of slope a n n^T it rests on the axis n of the body, to rounding whatever the sizes.
TEST(Uniqueness, NoiseThatVanishesDoesSoInEveryUnit) {
  const Vector3d across = oblique.unitOrthogonal();
  const Matrix3d along = oblique * oblique.transpose();
  for (const double radius : {1e-6, 1.0, 1e6})
    for (const double slope : {1e-6, 1.0, 1e6}) {
      sphere_problem p{one + 2 * along + 0.7 * across * across.transpose(), 0.2, radius, Matrix3d::Zero()};
      p.varying = {{Vector3d::Zero(), slope * along}};
      EXPECT_NE(no_unique_law(p).find("all noise vanishes"), std::string::npos) << radius << ' ' << slope;
      p.varying = {{Vector3d::Zero(), slope * (along + 1e-9 * Vector3d(1, 2, 3) * Vector3d(3, 1, -1).transpose())}};
      EXPECT_EQ(no_unique_law(p), "") << radius << ' ' << slope;
    }
}

TEST(Uniqueness, ANoiseOfNothingMovesNothing) {
  sphere_problem p{Vector3d(1, 2, 3).asDiagonal(), 0.2, 1, Matrix3d::Zero()};
  p.varying = {{Vector3d::Zero(), Matrix3d::Zero()}};
  EXPECT_NE(no_unique_law(p).find("all noise vanishes"), std::string::npos);
}

}  // namespace
}  // namespace polhode::test
