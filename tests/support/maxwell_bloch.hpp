// SPDX-License-Identifier: Apache-2.0
// The Maxwell-Bloch equations for tests.
#pragma once

#include <polhode/systems/maxwell_bloch.hpp>

namespace polhode::test {

inline maxwell_bloch atoms_in_light(double theta = 0.3, double sigma = 0.4) {
  return {theta, maxwell_bloch::isotropic(sigma)};
}

}  // namespace polhode::test
