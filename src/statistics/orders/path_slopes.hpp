// SPDX-License-Identifier: Apache-2.0
// The order of each path by itself: the slope of log2 |error| against log2 dt, by least squares over given levels.
//
// Slopes of single paths scatter, as a factor that changes from level to level at random does not fall with dt; their
// median is the order if the law of error / dt^order has a limit. Its 95 % interval is that of the order statistics
// (binomial ranks), which holds for any law of the slopes.
#pragma once

#include <optional>
#include <span>

#include "statistics/orders/order_fit.hpp"

namespace polhode {

struct path_slopes {
  order_fit median;           ///< of the paths; `used`, `asymptotic` as in the fit that chose the levels
  double low = 0, high = 0;   ///< the middle 95 % of the paths
  double share_at_least = 0;  ///< of the paths, those whose slope is at least `asked`
};

/// Levels: those that `chosen` uses. Paths with an error of zero or none that is finite are left out; empty where fewer
/// than 32 stay.
std::optional<path_slopes> fit_path_slopes(std::span<const double> dt, const squared_errors&, const order_fit& chosen,
                                           double asked);

}  // namespace polhode
