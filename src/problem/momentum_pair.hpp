// SPDX-License-Identifier: Apache-2.0
// A scene of two momenta as what is exact on products of spheres sees it.
#pragma once

#include <optional>

#include "problem/noise_covariance.hpp"
#include "sphere/products/sphere_pair.hpp"

namespace polhode {

/// The first and the last three components of the scene's momentum, with its dissipation and noise, and the energy
/// Pi_s.quadratic_s Pi_s / 2 + field.Pi_s of each. Nothing where one of them is zero: that is on no sphere.
inline std::optional<sphere_pair> momentum_pair(const report::scene& s, std::array<Eigen::Matrix3d, 2> quadratic,
                                                const Eigen::Vector3d& field, double exchange) {
  const auto covariance = covariance_of_noise<6>(s);
  const Eigen::Map<const Eigen::Matrix<double, 3, 2>> momentum(s.momentum.data());
  if ((momentum.colwise().norm().array() == 0).any()) return std::nullopt;
  const auto site = [&](int i) -> sphere_problem {
    return {quadratic[static_cast<std::size_t>(i)], dissipation_of(s), momentum.col(i).norm(),
            covariance.block<3, 3>(3 * i, 3 * i), field};
  };
  return sphere_pair{{site(0), site(1)}, exchange, covariance.block<3, 3>(0, 3)};
}

}  // namespace polhode
