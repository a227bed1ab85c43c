// SPDX-License-Identifier: Apache-2.0
// A spin with no symmetry, in a field along none of its axes.
#pragma once

#include <polhode/systems/spin.hpp>

namespace polhode::test {

inline spin tilted_spin(double theta = 0.4, double sigma = 0.5) {
  Eigen::Matrix3d quadratic;
  quadratic << 0.6, 0.1, -0.2, 0.1, -0.3, 0.15, -0.2, 0.15, -1.2;
  return {quadratic, {0.3, -0.2, 0.5}, theta, spin::isotropic(sigma)};
}

}  // namespace polhode::test
