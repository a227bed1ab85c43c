// SPDX-License-Identifier: Apache-2.0
// How finely a transfer operator is computed.
#pragma once

#include "transfer/points/noise_nodes.hpp"

namespace polhode {

/// The functions on which the operator acts.
struct basis_rule {
  int degree;         ///< of the harmonics
  int radial;         ///< Chebyshev polynomials; 1 on a sphere
  double deviations;  ///< of the radius in `steps` steps that the shell covers; 0 on a sphere
  bool operator==(const basis_rule&) const = default;
};

/// The functions, and the nodes of the noise.
struct transfer_rule {
  basis_rule basis;
  noise_rule noise;
  bool operator==(const transfer_rule&) const = default;
};

}  // namespace polhode
