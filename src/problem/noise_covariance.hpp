// Sum of sigma_i sigma_i^T over the noise vectors of a scene.
#pragma once

#include <Eigen/Core>

#include "problem/drives.hpp"

namespace polhode {

inline Eigen::Matrix3d noise_covariance(const report::scene& s) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& v : noise_vectors_of(s)) {
    const Eigen::Map<const Eigen::Vector3d> e(v.data());
    covariance += e * e.transpose();
  }
  return covariance;
}

}  // namespace polhode
