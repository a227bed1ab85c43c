// SPDX-License-Identifier: Apache-2.0
// From the exact operator of a step back to its generator, and from that to the body that it is of.
#include <gtest/gtest.h>

#include "sphere/generator_family.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "support/dense.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {
namespace {

constexpr int degree = 6;
const double theta = 0.5;

/// On a sphere of any radius.
sphere_problem body_of_radius(double radius) { return body_on_sphere({1, 2, 3}, theta, radius, oblique()); }

Eigen::MatrixXd generator_of(const sphere_problem& p) { return Eigen::MatrixXd(backward_operator(p, degree)); }
Eigen::MatrixXd fitted(const Eigen::MatrixXd& generator) { return generator.middleCols(1, 8); }

TEST(GeneratorFamily, TheLogarithmOfAStepIsItsGenerator) {
  const auto generator = generator_of(body_of_radius(1));
  for (const double dt : {0.01, 0.1}) {
    const auto found = generator_of_step(exponential_of(dt * generator), dt);
    ASSERT_TRUE(found) << dt;
    ASSERT_EQ(found->cols(), 8);
    EXPECT_LT((*found - fitted(generator)).norm(), 1e-9 * generator.norm()) << dt;
  }
}

TEST(GeneratorFamily, EveryBodyIsItsOwnNearest) {
  for (const double radius : {1.0, 1.7}) {
    const auto p = body_of_radius(radius);
    const auto found = generator_family(radius).nearest(fitted(generator_of(p)));
    EXPECT_LT(found.residual, 1e-13);
    const Eigen::Vector3d k(1, 1 / 2.0, 1 / 3.0), without_mean = k.array() - k.mean();
    EXPECT_LT((found.parameters.quadratic - without_mean).norm(), 1e-13) << radius;
    EXPECT_LT((found.parameters.dissipation - theta * without_mean).norm(), 1e-13) << radius;
    EXPECT_LT((found.parameters.noise - oblique()).norm(), 1e-13) << radius;
    const auto own = parameters_of(p);
    EXPECT_LT((own.quadratic - without_mean).norm() + (own.dissipation - theta * without_mean).norm() +
                  (own.noise - oblique()).norm(),
              1e-14);
  }
}

// Of another operator the part that no body has, over all of it: beside the rows that a body fills, and among them.
TEST(GeneratorFamily, WhatNoBodyExpressesIsLeft) {
  Eigen::MatrixXd columns = fitted(generator_of(body_of_radius(1)));
  const double size = columns.norm();
  columns(harmonic_index(5, 0), 2) = 3;
  const auto found = generator_family(1).nearest(columns);
  EXPECT_NEAR(found.residual, 3 / std::hypot(size, 3), 1e-12);
  EXPECT_LT((found.parameters.noise - oblique()).norm(), 1e-13);
  Eigen::MatrixXd constant = fitted(generator_of(body_of_radius(1)));
  constant(0, 4) = 2;  // no generator sends a function to a constant
  EXPECT_NEAR(generator_family(1).nearest(constant).residual, 2 / std::hypot(size, 2), 1e-12);
}

}  // namespace
}  // namespace polhode::test
