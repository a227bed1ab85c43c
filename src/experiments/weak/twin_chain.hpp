// SPDX-License-Identifier: Apache-2.0
// The law of the true solution from paths that share their noise, so that little variance is left.
//
// The twin Y_l of a level solves the equation that its increments drive, cut off from the areas inside its steps
// (driven_block.hpp). Neighbours f(Y_l) and f(Y_l+1) differ by those areas, with a standard deviation like dt^1/2. The
// same increments of level l+1 in the opposite order within each step of level l have the same law and areas of the
// opposite sign: the mean of f over both orders differs from f(Y_l) like dt (antithetic pairs: Giles, Szpruch, Ann.
// Appl. Probab. 24 (2014) 1585-1620). Along the chain Y_0, …, Y_L, X these differences add up.
#pragma once

#include <vector>

#include "experiments/common/driven_block.hpp"
#include "problem/observables.hpp"

namespace polhode {

/// Of one block of paths, advanced beside its driven_block.
class twin_chain {
 public:
  twin_chain(const subject&, const level_grid&, int cells, const driven_kernels&);

  /// Through the steps by which `truth` advanced last.
  void advance(const driven_block& truth);

  /// Of one path: for every level a number of the mean E[f(Y_l)] - E[f], and last one of the mean E[f(X)] - E[f]. What
  /// X, the finest of them, misses is taken out to second order of its step.
  std::vector<double> excess(const state_function&, const driven_block& truth, int lane) const;

 private:
  /// The steps of a view, each `group` of them in the opposite order; without areas.
  increment_view opposite(const increment_view&, int group);

  std::size_t channels_;
  int dimension_, cells_;
  const driven_kernels& kernels_;
  std::vector<std::vector<double>> states_;  ///< [l] of level l + 1, of the cells the last; driven in opposite order
  lane_vector<double> dw_;
  lane_vector<float> singles_;
};

}  // namespace polhode
