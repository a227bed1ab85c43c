// SPDX-License-Identifier: Apache-2.0
// Bodies on the sphere of the scene `paper`, their observables, and a start.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "sphere/expectations/expectation.hpp"

namespace polhode::test {

inline const Eigen::Vector3d start(0.6, 0.48, 0.64);
inline const Eigen::Matrix3d none = Eigen::Matrix3d::Zero(), one = Eigen::Matrix3d::Identity();

inline sphere_problem problem(double theta, const Eigen::Matrix3d& covariance) {
  return body_on_sphere({1, 2, 3}, theta, 1, covariance);
}
inline sphere_problem paper() { return problem(0.5, 0.25 * Eigen::Matrix3d::Identity()); }
inline sphere_function observable(std::string_view name) {
  return *named_observable(name, problem(0, Eigen::Matrix3d::Zero()));
}

inline Eigen::Matrix3d oblique() {
  Eigen::Matrix3d s;
  s << 0.5, 0.1, -0.2, 0, 0.3, 0.2, 0.1, 0, 0.6;
  return s * s.transpose();
}

inline void holds(const reference_value& found, double expected, double within) {
  ASSERT_TRUE(found.converged()) << found.reason;
  EXPECT_NEAR(*found.value, expected, within);
  EXPECT_LE(found.uncertainty, within);
}

}  // namespace polhode::test
