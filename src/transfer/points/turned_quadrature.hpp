// SPDX-License-Identifier: Apache-2.0
// A quadrature of the sphere that the half turns of a body map onto itself, and sums over its rings.
#pragma once

#include <Eigen/Core>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode {

/// The half turns as signs of the components: none, about axis 3, about 1, about 2.
inline const Eigen::Matrix<double, 4, 3> half_turns{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}};

/// sphere_quadrature of that degree or up to three more whose points come in fours, images of each other under half
/// turns: a quarter of the points first, then their images in the order of the turns. per_ring: 0.
sphere_rule turned_quadrature(int degree);

/// part += duals^T values, ring by ring: first cosines and sines of the longitude, then functions of the height. Of
/// degree L and many columns a share 5 / 2L of the work. The rings of turned_quadrature: above the equator half a ring
/// at longitudes 0 ... and the half opposite; below it their images under the half turns about axes 1 and 2.
void add_by_rings(const Eigen::MatrixXd& duals, int degree, const Eigen::Ref<const Eigen::MatrixXd>& values,
                  Eigen::MatrixXd& part);

}  // namespace polhode
