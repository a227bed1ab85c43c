// SPDX-License-Identifier: Apache-2.0
// Control variates of a path: what its noise did on the whole, of which the mean is known to vanish.
//
// What is left of f(X_dt) - f(X) is for the most part a response to the increments, linear in those of each part of the
// path and quadratic in their sums W: W_i and W_i W_j - delta_ij T are taken out by regression (control_variates.hpp).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/noise_layout.hpp"
#include "statistics/orders/squared_errors.hpp"

namespace polhode {

class path_controls {
 public:
  /// parts: of each path, all of the same length.
  path_controls(const noise_layout&, int parts, double horizon, int paths);

  /// The increments of one part, a single step, of a block of paths.
  void keep(int first_path, int part, const increment_view&);

  /// The same values, path by path and level by level, of less variance. All of the same number of paths.
  std::vector<squared_errors> taken_out_of(const std::vector<squared_errors>&) const;

 private:
  Eigen::MatrixXd of_paths(Eigen::Index paths) const;

  Eigen::Index channels_, parts_, stride_;
  double horizon_;
  Eigen::MatrixXd increments_;  ///< [path][part, channel]
};

}  // namespace polhode
