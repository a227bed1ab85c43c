// SPDX-License-Identifier: Apache-2.0
// Long runs of the flow and its tangents on the momentum sphere: growth of lengths and areas, path by path.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ensemble/tangent_controls.hpp"
#include "ensemble/tangent_kernel.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/noise_verdict.hpp"

namespace polhode {

/// How long the paths run: first until start and direction are forgotten, then observed.
struct run_length {
  double dt = 0;
  double forgetting = 0, observed = 0;  ///< in steps: whole, but they may be more than any integer
  double time() const { return dt * observed; }
};
/// At least those times.
run_length run_length_of(double dt, double forgetting, double observed);

/// Means over the observed time of each path. The controls have mean 0 for every scheme
/// (statistics/control_variates.hpp), as each is a sum over steps of what is known before the step times what has mean
/// 0 in it. With x the state, v the first tangent, w = x cross v, B = sum sigma_i dW^i, Q dt its covariance, (i,j,k)
/// cyclic, and P one of x x^T, v v^T / |v|^2, v w^T / |v|^2, they are
///   P_jk B_i,   (P_jj - P_kk) (B_i B_i - Q_ii dt),   P_jk (B_j B_k - Q_jk dt),
/// and six cubic forms times B_i. These are the lowest terms of the martingale sum X_i g B_i, g the solution of the
/// Poisson equation of the stretching rate, which for dt -> 0 is all the noise that there is in the growth.
struct growth {
  static constexpr int controls = tangent_control_count;
  Eigen::VectorXd length, area;  ///< [path], logarithmic growth per time: lambda_1 and lambda_1 + lambda_2
  Eigen::MatrixXd control;       ///< [path][control]
  explicit growth(int paths) : length(paths), area(paths), control(paths, controls) {}
};

/// Runs the block of paths of some schemes through one noise; of each, sees only its own kernel and writes only there.
void run_tangents(const context&, const run_length&, int block, std::span<const tangent_kernel* const> kernels,
                  bool with_areas, std::span<growth* const> out, noise_log* = nullptr);

}  // namespace polhode
