// SPDX-License-Identifier: Apache-2.0
// Turns as shears: the exact rotation to rounding, within their bounds and at every size of the orbit.
#include <gtest/gtest.h>

#include <cmath>

#include "systems/rigid_body/motion/body_parts.hpp"
#include "systems/rigid_body/motion/shear_rotation.hpp"

#include "support/schemes.hpp"
#include "systems/rigid_body/rigid_body_choice.hpp"

namespace polhode::test {
namespace {

constexpr auto bounds = rotations<rotation_size::tiny>::bounds;

/// The largest error in the angle, beyond what the rounding of the coefficients allows.
template <int degree>
double worst_angle(double bound) {
  const shear_rotation<degree> turn(bound, 1);
  const auto odd = [](const auto& p, long double x) {
    long double sum = 0;
    for (std::size_t k = p.size(); k-- > 0;) sum = sum * x * x + p[k];
    return sum * x;
  };
  long double worst = 0;
  for (int i = -1000; i <= 1000; ++i) {
    const long double x = i / 1000.0L, angle = bound * x, rounding = 3e-16L * std::fabs(angle);
    worst = std::max({worst, std::fabs(odd(turn.sine, x) - std::sin(angle)) - rounding,
                      2 * std::fabs(odd(turn.half_tangent, x) - std::tan(angle / 2)) - rounding});
  }
  return static_cast<double>(worst);
}

TEST(ShearRotation, ErrsInTheAngleByItsBoundAtMost) {
  EXPECT_LE(worst_angle<1>(bounds.half_turn), std::pow(bounds.half_turn, 5) / 960);
  EXPECT_LE(worst_angle<1>(0.1), std::pow(0.1, 5) / 950);
  EXPECT_GE(worst_angle<1>(0.1), std::pow(0.1, 5) / 1100) << "the bound is what it errs by";
  EXPECT_LE(worst_angle<2>(0.1), std::pow(0.1, 7) / 37e3);
  EXPECT_LE(std::pow(bounds.half_turn, 5) / 960, 1.5e-17);
  EXPECT_LE(std::pow(bounds.turn, 7) / 37e3, 4e-20);
}

template <int degree>
void is_the_rotation(double bound) {
  for (const double size : {1.0, 1e-50, 1e50})
    for (const double angle : {bound, -bound, 1e-3, 1e-9, 0.0})
      for (const double x : {1.0, -0.6, 1e-3, 0.0}) {
        const double rest = std::sqrt(1 - x * x), cos = std::cos(angle * x), sin = std::sin(angle * x);
        const vec<double, 3> start{{size * 0.8 * rest, size * x, size * 0.6 * rest}};
        const auto pi = shear_rotation<degree>(angle / size, size).template about<1>(start);
        EXPECT_NEAR(pi[1] / size, x, 1e-15);
        EXPECT_NEAR(pi[2] / size, (0.6 * cos + 0.8 * sin) * rest, 3e-16) << angle << ' ' << x;
        EXPECT_NEAR(pi[0] / size, (0.8 * cos - 0.6 * sin) * rest, 3e-16) << angle << ' ' << x;
      }
}

TEST(ShearRotation, IsTheRotationAboutItsAxis) {
  is_the_rotation<1>(bounds.half_turn);
  is_the_rotation<2>(bounds.turn);
}

// A body turns faster the longer its momentum is: the product with the step decides.
TEST(ShearRotation, IsChosenByAngleAndOnlyWherePowersOfTheMomentumAreNumbers) {
  EXPECT_EQ(rotation_size_of(paper_body(), 1, 0.01), rotation_size::tiny);
  EXPECT_GT(rotation_size_of(paper_body(), 1, 0.016), rotation_size::small) << "the first turn";
  const rigid_body long_last({1, 1.1, 0.5}, 0.5, constant_noise<so3>::isotropic(0.5));
  EXPECT_EQ(rotation_size_of(long_last, 1, 0.0030), rotation_size::tiny);
  EXPECT_EQ(rotation_size_of(long_last, 1, 0.0035), rotation_size::small) << "the last";
  const auto at_size = [](double c) {  // the same motion in other units
    return rotation_size_of({{1, 2, 3}, 0.5 / c, constant_noise<so3>::isotropic(0.5 * std::sqrt(c))}, c, 0.01 / c);
  };
  for (const double c : {1e-45, 0.1, 1e45}) EXPECT_EQ(at_size(c), rotation_size::tiny) << c;
  for (const double c : {1e-70, 1e70}) EXPECT_EQ(at_size(c), rotation_size::small) << c;
}

}  // namespace
}  // namespace polhode::test
