// SPDX-License-Identifier: Apache-2.0
// The equation of midpoint rules at any scale of the state, of dual numbers, and where it has no solution that is
// found.
#include <gtest/gtest.h>

#include <cmath>

#include <polhode/schemes/implicit_midpoint.hpp>
#include <polhode/systems/rigid_body.hpp>
#include <polhode/systems/son_body.hpp>

namespace polhode {
namespace {

using vector = vec<double, 3>;
const vector momentum{{0.6, -0.48, 0.64}}, far{{1.4, -0.9, 1.1}};

/// A body with its inertia and damping in the units of a state of that scale, which is a power of two.
vector scaled_step(double scale, const vector& dw, double dt) {
  const rigid_body body({scale, 2 * scale, 3 * scale}, 0.5 / scale, rigid_body::isotropic(1));
  return (1 / scale) * implicit_midpoint::step(body, scale * momentum, wiener<double, 3>{dt, dw});
}

// Near and far increments: a few corrections, more, and Newton's method from the beginning.
TEST(MidpointSolver, StepsStatesOfAnyScaleAlike) {
  for (const double size : {0.3, 1.0, 1.5, 2.0, 3.0, 5.0}) {
    const auto expected = scaled_step(1, size * far, 0.25);
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::isfinite(expected[k])) << size;
    for (const double scale : {0x1p-40, 0x1p40})
      EXPECT_EQ(scaled_step(scale, size * far, 0.25).c, expected.c) << scale << ' ' << size;
  }
}

son_body::state<double> scaled_step_of_four(double scale, double size) {
  const son_body body({0.5 * scale, 0.8 * scale, 1.1 * scale, 1.7 * scale}, 0.5 / scale,
                      constant_noise<son>::isotropic(1, 6));
  son_body::state<double> mu(6), dw(6);
  for (int k = 0; k < 6; ++k) {
    mu[k] = scale * std::sin(1.7 * k + 0.4);
    dw[k] = size * std::cos(2.3 * k);
  }
  return (1 / scale) * implicit_midpoint::step(body, mu, wiener<double, son::dimension>{0.1, dw});
}

TEST(MidpointSolver, StepsStatesOfOpenSizeAndAnyScaleAlike) {
  for (const double size : {0.1, 0.5, 1.5}) {
    const auto expected = scaled_step_of_four(1, size);
    for (const double scale : {0x1p-40, 0x1p40}) {
      const auto found = scaled_step_of_four(scale, size);
      for (int k = 0; k < 6; ++k) EXPECT_EQ(found[k], expected[k]) << scale << ' ' << size << ' ' << k;
    }
  }
}

// Against differences of steps from neighbours, and of increments.
TEST(MidpointSolver, OfDualsGivesTheDerivative) {
  const rigid_body body({1, 2, 3}, 0.5, rigid_body::isotropic(1));
  const vector dw{{0.4, -0.3, 0.5}}, along{{0.3, 0.8, -0.2}}, along_dw{{-0.5, 0.1, 0.7}};
  const auto step = [&](double h) {
    return implicit_midpoint::step(body, momentum + h * along, wiener<double, 3>{0.2, dw + h * along_dw});
  };
  using number = dual<double, 1>;
  vec<number, 3> x;
  wiener<number, 3> w{0.2, {}};
  for (int k = 0; k < 3; ++k) {
    x[k] = {momentum[k], {{along[k]}}};
    w.dw[k] = {dw[k], {{along_dw[k]}}};
  }
  const auto found = implicit_midpoint::step(body, x, w);
  const auto expected = (0.5 / 1e-5) * (step(1e-5) - step(-1e-5));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k].slope[0], expected[k], 1e-9) << k;
}

TEST(MidpointSolver, FailsInEveryComponent) {
  const rigid_body body({1, 2, 3}, 1e6, rigid_body::isotropic(1));
  const auto next = implicit_midpoint::step(body, 1e3 * momentum, wiener<double, 3>{10, {{0.1, 0.2, 0.3}}});
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isnan(next[k])) << k;
}

}  // namespace
}  // namespace polhode
