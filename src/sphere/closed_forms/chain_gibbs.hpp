// SPDX-License-Identifier: Apache-2.0
// The Gibbs law exp(-beta h) of coupled spins or bodies whose bonds form chains and rings, by transfer matrices between
// points of the sphere.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "sphere/galerkin/reference_value.hpp"

namespace polhode {

/// On the sphere |S| = length, of energy S.quadratic S / 2 + field.S by itself.
struct chain_site {
  Eigen::Matrix3d quadratic;
  Eigen::Vector3d field;
  double length;
};

/// h = sum of the sites' energies + sum_{i<j} exchange_ij S_i.S_j.
struct chain_gibbs {
  std::vector<chain_site> sites;
  Eigen::MatrixXd exchange;  ///< symmetric, the diagonal is not looked at
  double beta = 0;

  /// Whether no site has more than two bonds.
  bool solvable() const;

  /// Of energy, of a component s2_3 or mu_6 (the third of the second site), or of its square (s2_3^2, mu_6^2); nothing
  /// for another name. Uncertain by what half as many points in a direction change.
  std::optional<reference_value> mean(std::string_view observable) const;
};

}  // namespace polhode
