// SPDX-License-Identifier: Apache-2.0
#include "sphere/closed_forms/linearised.hpp"

#include "algebra/decompositions.hpp"
#include "sphere/equilibria.hpp"

namespace polhode {

linearised_equation linearised_about(const sphere_problem& p, const Eigen::Vector3d& direction, double sigma) {
  const Eigen::Matrix2d h = curvature_at(p, direction);
  Eigen::Matrix2d turn;
  turn << 0, -1, 1, 0;
  return {p.radius * turn * h - p.damping * p.radius * p.radius * h, sigma};
}

double mean_square_growth(const linearised_equation& e) {
  const auto& a = e.drift;
  const double sum = a(0, 0) + a(1, 1), stretch = a(0, 0) - a(1, 1), shear = a(0, 1) + a(1, 0),
               turn = a(0, 1) - a(1, 0), lost = 2 * e.noise * e.noise;
  // The turns of the noise by an angle turn what is not isotropic by twice that, and average it away.
  Eigen::Matrix3d moments;
  moments << sum, stretch, shear, stretch, sum - lost, turn, shear, -turn, sum - lost;
  return eigenvalues_of(moments).real().maxCoeff();
}

}  // namespace polhode
