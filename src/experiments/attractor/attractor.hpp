// SPDX-License-Identifier: Apache-2.0
// The parts of the experiment `attractor`, and what they all rest on.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ensemble/simulation.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/recorder.hpp"
#include "sphere/lyapunov.hpp"
#include "sphere/stationary.hpp"

namespace polhode {

/// Known without sampling, once for all parts.
struct attractor_frame {
  sphere_problem problem;
  stationary_law law;                 ///< the true one
  lyapunov_exponents exponents;       ///< lambda1 may be missing, with a reason
  double gap = 0;                     ///< the slowest rate at which one body forgets its start
  double dt = 0;                      ///< coarse, a quarter of the fastest time scale: a bias is seen
  std::vector<scheme_entry> schemes;  ///< those that keep the sphere

  double lambda2() const { return exponents.sum - *exponents.lambda1; }
  /// At least one.
  std::int64_t steps_in(double time, double step) const;
};

/// A path's noise that is common to many bodies: fast normals.
noise_source fast_noise(const context&);

/// Bodies from a uniform start under the noise of path 0; how many, how long and with which areas is left open.
simulation_plan common_noise_plan(const context&);

/// Path-steps of one scheme that a part may take, given those at quick effort.
double affordable(effort, double path_steps_at_quick);

/// Is told of a path's noise.
using path_listener = std::function<void(int path, const increment_view&)>;

// Each part tells the log of its noise path by path, whatever the number of bodies: of one scheme, as all have the same
// paths.

/// Averages over noise paths against the true law.
void report_averages(const context&, const attractor_frame&, noise_log&, report::results&);
/// Snapshots at time 0 of bodies that started at -T, one noise.
void report_pullback(const context&, const attractor_frame&, noise_log&, report::results&);
/// The rate at which close bodies meet or part.
void report_neighbours(const context&, const attractor_frame&, noise_log&, report::results&);
/// Where lambda_1 > 0: dimensions of snapshots, without a claim.
void report_dimensions(const context&, const attractor_frame&, noise_log&, report::results&);
/// Densities to look at: bodies under one noise path at half, one, two and four units of time.
struct snapshots {
  std::string name;
  double unit;  ///< the time in which the volume of a set shrinks by e
  double dt;
  ensemble_start start = ensemble_start::uniform;
  int pictured = 0;  ///< the first of the three components whose direction is counted
};
void report_snapshots(const context&, const snapshots&, noise_log&, report::results&);
/// These, and the true law.
void report_densities(const context&, const attractor_frame&, noise_log&, report::results&);

}  // namespace polhode
