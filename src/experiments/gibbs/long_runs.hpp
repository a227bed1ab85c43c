// SPDX-License-Identifier: Apache-2.0
// Time averages of long runs of any scheme at any step, against the exact means of the Gibbs law: what the choice of an
// integrator asks off the sphere.
//
// A path starts from the law of the driven equation, one of a pool of states that have forgotten theirs
// (relaxation.hpp), forgets that for three autocorrelation times and is averaged over twenty. The average of a path is
// one sample, so that an interval over paths knows the autocorrelation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/gibbs/relaxation.hpp"
#include "statistics/orders/squared_errors.hpp"

namespace polhode {

/// Why no exact means are known of a long run on this scene; empty: some are.
std::optional<std::string> no_gibbs_means(const subject&);

class long_runs {
 public:
  /// Of those observables whose exact mean is known and that scatter. Where `reason` says something nothing can be run.
  long_runs(const context&, const std::vector<observable>&);

  const std::string& reason() const { return reason_; }
  const std::vector<observable>& observables() const { return observables_; }
  double exact(std::size_t f) const { return exact_[f]; }
  double uncertainty(std::size_t f) const { return uncertainty_[f]; }  ///< of the exact mean
  double deviation(std::size_t f) const { return deviation_[f]; }
  /// Root of the mean square under the law.
  double size(std::size_t f) const;
  double relaxation_time() const { return time_; }
  /// Independent samples that the average of one path is worth.
  static double worth_of_a_path();
  double steps_of_a_path(double dt) const;

  /// Average less exact mean, [path][observable], of the paths of the blocks from … to - 1. Any thread.
  void run(const scheme_entry&, double dt, std::uint64_t seed, int from, int to, squared_errors& out) const;

 private:
  void fill_pool(double dt);
  void run_block(const kernel&, bool areas, std::uint64_t seed, int block, squared_errors& out) const;

  context context_;
  std::string reason_;
  std::vector<observable> observables_;
  std::vector<double> exact_, uncertainty_, deviation_;
  double time_ = 0;
  std::vector<std::vector<double>> pool_;  ///< states of blocks
};

}  // namespace polhode
