// SPDX-License-Identifier: Apache-2.0
// A heavy top for tests: asymmetric, its centre of mass off every axis.
#pragma once

#include <polhode/systems/heavy_top.hpp>

namespace polhode::test {

inline heavy_top asymmetric_top(double theta = 0.3, double sigma = 0.3) {
  return {{1, 1.5, 2.2}, 0.8, {0.3, -0.4, 0.6}, theta, heavy_top::isotropic(sigma)};
}

inline constexpr vec<double, 6> top_state{{0.5, -0.3, 0.7, 0.48, 0.6, 0.64}};

}  // namespace polhode::test
