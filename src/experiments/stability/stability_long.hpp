// SPDX-License-Identifier: Apache-2.0
// What only very many steps or very many paths show. At effort thorough.
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/stability/stability_case.hpp"
#include "experiments/stability/stability_limit.hpp"

namespace polhode {

/// The drift of |Pi| over steps of dt: 64 paths that start spread over the sphere; relative, root mean square.
struct long_drift {
  std::vector<double> steps, rms;  ///< at 2^16 steps, every doubling of that, and the end
};
long_drift drift_over(const subject&, const scheme_entry&, double dt, double steps, std::uint64_t seed, noise_generator,
                      const block_listener& hear = {});

/// Of so many steps is `hear` told.
inline constexpr std::int64_t heard_steps = 1 << 20;

/// A power law of that drift over 10^9 steps (10^8 of an implicit scheme) at the scene's finest dt, for a scheme that
/// claims the Casimirs.
void report_long_drift(const context&, const scheme_entry&, recorder&, const block_listener& hear = {});

/// The share of a million paths that breaks at half the largest stable dt, with its exact binomial interval; fewer
/// paths where that would be more than 2 10^10 steps.
void report_rare_breaks(const context&, const stability_case&, const scheme_entry&, const stability_limit&, recorder&,
                        const block_listener& hear = {});

}  // namespace polhode
