// SPDX-License-Identifier: Apache-2.0
// Expectations as functions of time within their stated uncertainty, and those of a path without noise.
#include "sphere/expectations/expectation_curve.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "sphere/expectations/deterministic.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

TEST(ExpectationCurve, IsTheExpectationAtEveryTime) {
  const std::vector<sphere_function> functions{observable("energy"), observable("pi1"), observable("pi3")};
  const Eigen::Vector3d scale(0.1, 1, 2);
  const double horizon = 3;
  for (const double accuracy : {1e-2, 1e-5, 1e-9}) {
    const auto curve = expectations(paper(), functions, scale, start, horizon, accuracy);
    EXPECT_EQ(curve.reason(), "");
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double bar = curve.uncertainty()[i];
      EXPECT_GT(bar, 0);
      EXPECT_LE(bar, 10 * accuracy * scale[i]);
      for (const double t : {0.0, 0.07, 0.5, 1.1, 2.9, horizon}) {
        const auto exact = expectation(paper(), functions[static_cast<std::size_t>(i)], start, t, 1e-11);
        EXPECT_NEAR(curve.at(t)[i], *exact.value, bar + exact.uncertainty) << accuracy << ' ' << i << ' ' << t;
      }
    }
  }
}

// About an axis nothing moves, and two ways of following that agree to the last digit: rounding is left, of one or
// more.
TEST(Deterministic, IsNeverMoreCertainThanRounding) {
  const auto p = problem(0.5, Eigen::Matrix3d::Zero());
  const auto uncertainty_of = [&](double size) {
    const auto found = on_the_path(
        p, [=](const Eigen::Vector3d& pi) { return size * pi[2]; }, Eigen::Vector3d::UnitZ(), 2);
    EXPECT_EQ(found.value, size);
    return found.uncertainty;
  };
  EXPECT_GT(uncertainty_of(1), 1e-16);
  EXPECT_LT(uncertainty_of(1), 1e-9);
  EXPECT_NEAR(uncertainty_of(1e6), 1e6 * uncertainty_of(1), 1e-9 * uncertainty_of(1e6));
  EXPECT_EQ(uncertainty_of(1e-6), uncertainty_of(1));
}

}  // namespace
}  // namespace polhode::test
