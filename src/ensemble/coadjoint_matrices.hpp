// SPDX-License-Identifier: Apache-2.0
// The coadjoint action of a system as matrices: what is linear algebra about its orbits.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ensemble/model.hpp"

namespace polhode {

/// C(e_k), k = 0 …: ad*_xi mu = sum_k xi_k C(e_k) mu.
std::vector<Eigen::MatrixXd> coadjoint_matrices(const model&);

/// Whether |mu| is the same all over each orbit, as on the dual of a compact algebra: then every orbit is compact.
bool keeps_length(const model&);

/// The first of three components 3k, 3k+1, 3k+2 whose length every motion keeps, as of a spin or of the vertical of a
/// top: their direction is a point of a sphere. Nothing where there are none.
std::optional<int> kept_vector(const model&);

}  // namespace polhode
