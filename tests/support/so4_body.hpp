// SPDX-License-Identifier: Apache-2.0
// The built-in scene of two coupled bodies, as a system.
#pragma once

#include <polhode/systems/so4_body.hpp>

namespace polhode::test {

inline so4_body coupled_bodies(double theta = 0.4, const so4_body::matrix& sigma = 0.3 * so4_body::matrix::Identity()) {
  return {{1, 2, 3, 1.25, 2.5, 1 / 0.6}, 0.3, theta, constant_noise<so4>(sigma)};
}

}  // namespace polhode::test
