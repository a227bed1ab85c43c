// SPDX-License-Identifier: Apache-2.0
// Two Lie-Poisson diffusions, each on its sphere of momentum, that feel each other: two bodies or two spins.
//
//   dPi_s = Pi_s x (Omega_s + damping_s Pi_s x Omega_s) dt + sum_k Pi_s x sigma_ks o dW^k    (Stratonovich), s = 1, 2,
//   h = h_1(Pi_1) + h_2(Pi_2) + exchange Pi_1.Pi_2,   Omega_s = dh/dPi_s
#pragma once

#include <Eigen/Core>
#include <array>

#include "sphere/sphere_problem.hpp"

namespace polhode {

/// Each site as it would be alone, with constant noise; `between`: sum_k sigma_k1 sigma_k2^T, zero where no noise is
/// shared. Together with the covariances of the sites it is positive semidefinite.
struct sphere_pair {
  std::array<sphere_problem, 2> sites;
  double exchange = 0;
  Eigen::Matrix3d between = Eigen::Matrix3d::Zero();

  double energy(const Eigen::Vector3d& one, const Eigen::Vector3d& other) const {
    return sites[0].energy(one) + sites[1].energy(other) + exchange * one.dot(other);
  }
  bool has_noise() const { return sites[0].has_noise() || sites[1].has_noise(); }
};

}  // namespace polhode
