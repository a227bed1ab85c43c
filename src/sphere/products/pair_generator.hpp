// SPDX-License-Identifier: Apache-2.0
// The generator of two coupled diffusions on products of spherical harmonics, by Kronecker products of operators of one
// sphere.
//
//   L = L_1 + L_2 + sum_j (D_1j M[x_2j] + M[x_1j] D_2j) + sum_jk between_jk L_1j L_2k
//
// L_s is the generator of each alone (sphere/harmonics/backward_operator.hpp). The exchange is to each a field along
// the other momentum: D_sj is the drift of a site in the field exchange c e_j, c the radius of the other.
#pragma once

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/products/sphere_pair.hpp"

namespace polhode {

/// From the functions of l_1 + l_2 up to the degree to those two degrees higher: exact. Column 0 vanishes.
sparse_matrix tall_backward_operator(const sphere_pair&, int degree);

}  // namespace polhode
