// Long runs of the flow and its tangents on the momentum sphere: growth of lengths and areas, path by path.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ensemble/tangent_kernel.hpp"
#include "experiments/experiment.hpp"

namespace polhode {

/// How long the paths of one level run: first until start and direction are forgotten, then observed.
struct run_length {
  double dt = 0;
  double forgetting = 0, observed = 0;  ///< in steps: whole, but they may be more than any integer
  double time() const { return dt * observed; }
};
/// At least those times.
run_length run_length_of(double dt, double forgetting, double observed);

/// Means over the observed time of each path. Controls have mean 0 for every scheme (statistics/control_variates.hpp):
/// with x the state, v the first tangent, w = x cross v, and F one of x x^T, v v^T / |v|^2, v w^T / |v|^2, they are
/// sum_n F_jk(n) dW^i(n), (i,j,k) cyclic. In the limit dt -> 0 and over all F, X_i of the solution of the Poisson
/// equation of the stretching rate, no variance would be left; these are the lowest ones.
struct growth {
  static constexpr int controls = 9;
  Eigen::VectorXd length, area;  ///< [path], logarithmic growth per time: lambda_1 and lambda_1 + lambda_2
  Eigen::MatrixXd control;       ///< [path][control]
  explicit growth(int paths) : length(paths), area(paths), control(paths, controls) {}
};

/// Runs the block of paths of some schemes through one noise; of each, sees only its own kernel and writes only there.
/// The paths of `level` are others than those of another level.
void run_tangents(const context&, const run_length&, int level, int block,
                  std::span<const tangent_kernel* const> kernels, bool with_areas, std::span<growth* const> out);

}  // namespace polhode
