// SPDX-License-Identifier: Apache-2.0
// Sum of sigma_i sigma_i^T over the noise vectors of a scene.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "problem/drives.hpp"

namespace polhode {

template <int N = Eigen::Dynamic>
Eigen::Matrix<double, N, N> covariance_of_noise(const report::scene& s) {
  const auto n = static_cast<Eigen::Index>(s.momentum.size());
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero(n, n);
  for (const auto& v : noise_vectors_of(s)) {
    const Eigen::Map<const Eigen::Matrix<double, N, 1>> e(v.data(), n);
    covariance += e * e.transpose();
  }
  return covariance;
}

inline Eigen::Matrix3d noise_covariance(const report::scene& s) { return covariance_of_noise<3>(s); }

/// sigma where the vectors are sigma e_1 … sigma e_n or a rotation of these; 0 where the noise is not isotropic.
inline double isotropic_strength(const report::scene& s) {
  const auto covariance = covariance_of_noise(s);
  const auto n = covariance.rows();
  const double square = covariance.trace() / static_cast<double>(n);
  const bool isotropic = (covariance - square * Eigen::MatrixXd::Identity(n, n)).norm() <= 1e-12 * square;
  return isotropic ? std::sqrt(square) : 0;
}

}  // namespace polhode
