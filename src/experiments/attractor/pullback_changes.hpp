// SPDX-License-Identifier: Apache-2.0
// How much the snapshot at time 0 changes when the same noise has acted for longer.
//
// Bodies start uniformly at -T_1, -T_2, … and see the noise of one path up to time 0; the step before time 0 has the
// same noise for every T. Two sets of bodies that know nothing of each other give c, c' at each T, and the product of
// their changes, (c_T - c_T+).(c'_T - c'_T+), has the square of the change of the random measure itself as its mean:
// that the sets are finite adds scatter and no bias. A path has several times 0, a span apart: bodies that are of age T
// at one of them are of the next T at the next, so that a look costs seven spans in place of 28.
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/attractor/attractor.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {

inline constexpr int pullback_spans = 7;  ///< to the longest T, of which six changes are left

struct pullback_plan {
  std::int64_t steps;  ///< between two starts
  int paths, blocks;   ///< blocks of bodies a set
  int looks;           ///< at a path, a span apart

  std::int64_t all_steps() const { return (pullback_spans + looks - 1) * steps; }
  /// Of one set and scheme.
  std::int64_t spans_run() const { return looks * pullback_spans + pullback_spans * (pullback_spans - 1) / 2; }
};

/// Squares of the change from T to the next T, mean over the looks at a path: by scheme and noise path. All schemes see
/// the same noise, and the log hears it.
std::vector<squared_errors> pullback_changes(const context&, const attractor_frame&, const pullback_plan&, noise_log&,
                                             std::size_t part);

}  // namespace polhode
