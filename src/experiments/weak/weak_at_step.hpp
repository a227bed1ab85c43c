// SPDX-License-Identifier: Apache-2.0
// The weak error of any scheme at one step size, sampled: what the choice of an integrator asks where no operator can
// tell.
//
// Schemes share their noise with the driven equation. Of each of its paths a number is kept whose mean is E[f(X_t)]
// without the bias of its own step (twin_chain.hpp), so that every scheme is held against the same paths.
#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "experiments/common/driven_block.hpp"
#include "experiments/weak/path_controls.hpp"
#include "problem/observables.hpp"

namespace polhode {

class weak_at_step {
 public:
  static constexpr int most_times = 4;  ///< of a path at which it is looked at, the end among them

  /// rate: the system's fastest. Keeps context and observables by reference. Room for so many paths, whole blocks.
  weak_at_step(const context&, std::uint64_t seed, const std::vector<observable>&, double horizon, int steps,
               double rate, int most_paths);

  /// Columns of what is sampled: [time][observable].
  int columns() const { return static_cast<int>(times_.size() * observables_.size()); }
  const std::vector<double>& times() const { return times_; }
  /// Cells of the truth in a step, of which areas are made.
  int cells() const { return cells_in_a_step_; }
  /// Steps of the driven equation that a path takes, all in all.
  double work() const;

  /// f(X_dt) - f(X), path by path, of the paths of the blocks from … to - 1, to its place in `out`. Any thread.
  void run(const scheme_entry&, int from, int to, squared_errors& out);
  /// The same values of less variance (path_controls.hpp).
  squared_errors controlled(const squared_errors& of) const { return controls_.taken_out_of({of})[0]; }
  /// Root mean square of f(X_t), [time][observable], over the paths of so many blocks.
  std::vector<double> sizes(int blocks);

 private:
  struct truth_of_block {
    std::vector<double> areas_known, areas_unknown;  ///< [column][lane]
  };
  void extend(int blocks);
  void run_truth(int block);
  void run_scheme(const kernel&, bool with_areas, int block, squared_errors& out) const;

  context context_;
  const std::vector<observable>& observables_;
  level_grid grid_;
  int cells_in_a_step_;
  driven_kernels driven_;
  std::vector<int> looks_;  ///< after so many steps
  std::vector<double> times_;
  path_controls controls_;
  std::mutex extending_;
  int known_ = 0;  ///< blocks
  std::vector<truth_of_block> truth_;
};

}  // namespace polhode
