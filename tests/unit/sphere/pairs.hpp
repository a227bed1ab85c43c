// SPDX-License-Identifier: Apache-2.0
// Pairs of spins and of bodies, and the starts of two.
#pragma once

#include <Eigen/Core>

#include "sphere/products/pair_expectations.hpp"
#include "unit/sphere/problems.hpp"

namespace polhode::test {

using momenta = Eigen::Matrix<double, 6, 1>;

inline const Eigen::Vector3d first(0, 0.6, 0.8), second(0.8, 0, -0.6);

inline momenta both(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  momenta out;
  out << a, b;
  return out;
}

/// Two unit spins that nothing but exchange binds, each under isotropic noise: of its own, or the same.
inline sphere_pair bound(double exchange, double damping, double sigma, bool same_noise) {
  const sphere_problem spin{none, damping, 1, sigma * sigma * one};
  return {{spin, spin}, exchange, same_noise ? Eigen::Matrix3d(sigma * sigma * one) : none};
}

inline sphere_pair bodies() {
  return {{body_on_sphere({1, 2, 3}, 0.4, 1, 0.09 * one), body_on_sphere({1.25, 2.5, 1.6}, 0.4, 1, 0.09 * one)}, 0.3};
}

inline reference_value expected(const sphere_pair& pair, const momenta& from, double time, const char* name,
                                double share) {
  return pair_expectations(pair, from, time).of(*site_observable_named(name, 2), share);
}

}  // namespace polhode::test
