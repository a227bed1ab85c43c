// SPDX-License-Identifier: Apache-2.0
// The Gibbs law exp(-beta h) of the heavy top on its orbit |Gamma| = 1, Pi.Gamma = k.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "sphere/galerkin/reference_value.hpp"

namespace polhode {

/// Given Gamma, Pi is normal with mean k I Gamma / (Gamma.I Gamma) and covariance (I - I Gamma (I Gamma)^T / Gamma.I
/// Gamma) / beta; Gamma has the density (Gamma.I Gamma)^(-1/2) exp(-beta k^2 / (2 Gamma.I Gamma) - beta pull.Gamma) on
/// the sphere. The first is integrated in closed form, the second by quadrature.
struct heavy_top_gibbs {
  Eigen::Vector3d inertia;  ///< > 0
  Eigen::Vector3d pull;     ///< weight times axis
  double along = 0;         ///< k
  double beta = 0;          ///< 2 theta / sigma^2 > 0

  /// Of energy, pi_k, gamma_k and their squares (k = 1, 2, 3), or of mu_1 … mu_6; nothing for another name. Uncertain
  /// by what half as many points in a direction change.
  std::optional<reference_value> mean(std::string_view observable) const;
};

}  // namespace polhode
