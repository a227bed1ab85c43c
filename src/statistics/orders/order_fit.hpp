// SPDX-License-Identifier: Apache-2.0
// Orders of convergence with intervals.
//
// Which levels take part is a rule fixed in advance (level_choice.hpp). Where the coarsest of those that do is still
// off the line through the others by more than 0.05 in log2 (its 95 % interval, paths resampled), or without sampling
// error any of them off the line through all, the slope is not asymptotic yet.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "statistics/orders/squared_errors.hpp"
#include "statistics/sample.hpp"

namespace polhode {

struct order_fit {
  double order = 0, low = 0, high = 0;  ///< slope in log2-log2 with its 95 % interval
  double prefactor = 0;                 ///< value = prefactor * dt^order
  std::vector<bool> used;               ///< per level
  std::string rule;                     ///< what was left out, and why
  bool asymptotic = true;               ///< no curvature is seen
  interval_estimate finest;             ///< slope between the two finest levels used
};

/// Values without sampling error. The interval is Student's, from the scatter about the line.
std::optional<order_fit> fit_order(std::span<const double> dt, std::span<const double> value, double floor);

/// Values against any abscissa, all of them used: a growth law rather than an order.
std::optional<order_fit> fit_power_law(std::span<const double> x, std::span<const double> value);

/// Root-mean-square errors against dt, weighted least squares; the interval by resampling paths (levels share them),
/// the choice of levels with them.
std::optional<order_fit> fit_order(std::span<const double> dt, const squared_errors&, double floor, std::uint64_t seed);

/// Errors of coupled levels in L^p: (mean |error|^p)^(1/p).
struct error_norm {
  const squared_errors* squares;
  double p = 2;
};

/// The orders of several norms at once, each as fit_order; all from the same paths, resampled alike.
std::vector<std::optional<order_fit>> fit_orders(std::span<const double> dt, std::span<const error_norm>, double floor,
                                                 std::uint64_t seed);

/// The order of |mean| itself of any values of coupled levels. Levels whose mean is within `resolved` standard errors
/// of zero leave the fit, as resampled means have a logarithm too.
std::optional<order_fit> fit_order_of_clear_means(std::span<const double> dt, squared_errors values, double resolved,
                                                  std::uint64_t seed);

/// The power in the growth law of the mean against any abscissa; all levels take part whose mean is positive.
std::optional<double> power_of_means(std::span<const double> x, const squared_errors& values);

/// The mean square error in powers of dt, weighted least squares over the used levels.
struct error_model {
  interval_estimate limit;    ///< distance left at dt = 0 (not squared), with its 95 % interval (paths resampled):
                              ///< limit^2 + leading dt^2p + next dt^(2p+1)
  interval_estimate leading;  ///< coefficient of dt^2p in a fit without limit: above zero, the order is p and no more
};
/// powers: how many powers of dt, from dt^2p on, the fit without limit has; at most as many as levels are used.
error_model fit_error_model(std::span<const double> dt, const squared_errors&, const std::vector<bool>& used,
                            double order, std::uint64_t seed, int powers = 2);

}  // namespace polhode
