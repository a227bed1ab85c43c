// SPDX-License-Identifier: Apache-2.0
// Random and extreme scenes for the attack on the references.
#pragma once

#include <array>
#include <random>
#include <string>

#include "sphere/sphere_problem.hpp"

namespace polhode::test {

struct attacked_scene {
  sphere_problem problem;
  Eigen::Vector3d start;
  double time;
  bool isotropic;
};

std::array<double, 3> inertia_of(const sphere_problem&);

/// All of it, to be drawn again.
std::string words(const attacked_scene&);

/// tame: noise, dissipation and shear of about one size, so that most is answered. Else theta and noise from 1e-6 to
/// 1e3, radius from 1e-3 to 1e3, time from 1e-6 to 1e9.
attacked_scene drawn_scene(std::mt19937_64&, bool tame);

}  // namespace polhode::test
