// SPDX-License-Identifier: Apache-2.0
// How long does the equation itself take to forget its start?
//
// Found on a pilot run of the driven equation (references/wong_zakai_equation.hpp). Half of its paths begin at the
// scene's momentum, the other half spread over the orbit by noise and motion without dissipation, so that a well of h
// which keeps one half is seen by the other. A segment as long as all that went before it is looked at, and doubled
// until its two halves and both kinds of start have the same means and it is many autocorrelation times long.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "problem/observables.hpp"

namespace polhode {

/// The states of a block after the steps 0 … steps - 1 of its noise.
struct paths_so_far {
  std::vector<double> states;
  std::uint64_t steps = 0;
};
/// Every second lane at the scene's momentum, the others spread over the orbit by isotropic noise of strength sigma for
/// a time of 3 / sigma^2. log: is given the noise.
paths_so_far spread_start(const context&, double dt, std::uint64_t first_path, noise_log* log = nullptr, int block = 0);

struct relaxation {
  double time = 0;                ///< the longest integrated autocorrelation time of the observables
  std::vector<double> deviation;  ///< standard deviation of each
  std::string reason = {};        ///< why the start is not seen to be forgotten; empty: it is
};

/// The steps of dt; most_steps: of a path. The blocks begin at path first_path.
relaxation relaxation_of(const context&, const std::vector<observable>&, double dt, double most_steps,
                         std::uint64_t first_path);

}  // namespace polhode
