// SPDX-License-Identifier: Apache-2.0
// Means of the real harmonics over bodies: the coefficients of their density.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "transfer/basis/shell_basis.hpp"

namespace polhode {

/// Of degrees 1 … degree, in units in which the density is relative to the uniform one: c_lm = sqrt(4 pi) mean(Y_lm),
/// so that |c - c'| is the largest difference that two laws give to the mean of any function of these degrees whose
/// mean square over the sphere is one.
class harmonic_moments {
 public:
  explicit harmonic_moments(int degree);

  /// One block of bodies, [component][lane]. What is not finite makes the means so.
  void add(std::span<const double> states);
  /// The means over all that was added since the last call.
  Eigen::VectorXd take();
  /// The same, a column for each sum_lanes neighbouring lanes.
  Eigen::MatrixXd take_by_neighbours();

  /// The same coefficients of a density in harmonics against the area of the unit sphere.
  static Eigen::VectorXd of_density(const Eigen::VectorXd& density, int degree);

 private:
  shell_basis basis_;
  int bodies_ = 0;
  std::vector<double> sums_;
};

}  // namespace polhode
