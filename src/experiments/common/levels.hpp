// SPDX-License-Identifier: Apache-2.0
// Step sizes at which orders are looked for: the scene's own numbers of steps, halved on until the step is short
// against every rate of the system, so that a slope is asymptotic.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problem/subject.hpp"

namespace polhode {

struct level_grid {
  double horizon = 0;      ///< the scene's, or four times the fastest time scale if that is shorter
  std::vector<int> steps;  ///< increasing; of asymptotic_levels each twice the one before
  std::vector<double> dt() const {
    std::vector<double> out;
    for (const int n : steps) out.push_back(horizon / n);
    return out;
  }
};

/// The fastest rate of the system at its initial momentum: rotation, dissipation and noise added.
double fastest_rate(const subject&);

/// What an error of the energy is measured by: |h| at the start; where that happens to be next to zero, |mu| times the
/// rate of the motion.
double energy_size(const subject&);

/// The scene's finest step, or a quarter of the fastest time scale where that is shorter.
double finest_step(const subject&);

/// The longest step at which a stationary law is asked for: four times the fastest time scale.
double longest_at_equilibrium(const subject&);

/// The finest dt times the fastest rate is at most 1/resolution.
level_grid asymptotic_levels(const subject&, double resolution);

/// Of the fastest time scales: runs over more are out of reach.
inline constexpr double most_time_scales = 1e5;

/// Why what happens at the horizon is; empty: it is not.
std::optional<std::string> beyond_reach(const subject&);

/// The scene's own numbers of steps and its horizon, or of one that is within reach. Where these are fewer than five:
/// halved while a step stays short against the fastest rate, else doubled. Doubled further until the finest dt times
/// that rate is at most 1/64.
level_grid scene_levels(const subject&);

}  // namespace polhode
