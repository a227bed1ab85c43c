// SPDX-License-Identifier: Apache-2.0
// Values without sampling error as a power series of the step.
//
//   y(dt) = c_0 + c_1 dt + c_2 dt^2 + …        (of errors: Talay, Tubaro, Stoch. Anal. Appl. 8 (1990) 483)
//
// A scheme converges to the right law where c_0 of its error is 0, and at order p where c_1 … c_(p-1) vanish as well.
// Two rules, both fixed in advance:
//
//   all levels    the polynomial through all of them. Right for values known nearly to rounding whose coarsest step is
//                 well inside the series' reach: each level takes one more term away. Its certainty presumes that terms
//                 fall off, and is now and then too small where they grow like 4^k and the coarsest dt is 1/4.
//   best degree   the polynomial through the finest levels, of the degree whose certainty is tightest. Right for values
//                 known to a share of themselves, where it is mostly the narrower one with many levels, or a coarsest
//                 step near the end of the series' reach: it may leave coarse levels out, and two comparisons bound
//                 what is cut off. On exact values it is nearly always wider, so it does not replace the other
//                 (tests/unit/statistics/power_series_test.cpp).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "statistics/sample.hpp"

namespace polhode {

/// c_0 … c_(count-1) by all levels (Richardson's extrapolation to dt = 0), which have different dt. Half-width of an
/// interval: three times the change from the polynomial without the coarsest level, that is the next term of the series
/// (or an eighth of the change before, should that term happen to vanish), and what the values are uncertain by, each
/// at its worst. At least count + 2 levels.
std::vector<interval_estimate> series_by_all_levels(std::span<const double> dt, std::span<const double> value,
                                                    std::span<const double> uncertainty, std::size_t count);

/// One coefficient of the series: value +- certainty().
struct expansion_term {
  double value = 0;
  double propagated = 0;  ///< by the uncertainties of the levels
  double truncated = 0;   ///< by the terms that the polynomial leaves out
  int degree = 0;         ///< of the polynomial
  double certainty() const { return propagated + truncated; }
};

/// c_k by the best degree, from values with uncertainties at decreasing dt; levels that are not finite are left out.
/// For every degree d up to eight the polynomial through the d + 1 finest levels. The levels' uncertainties enter at
/// their worst; what the series is cut off by is judged by what changes when the degree falls by one and when all
/// levels move one coarser, the larger of the two. The degree with the least sum is taken. Empty where fewer than
/// max(k, 1) + 2 levels are left.
std::optional<expansion_term> series_term_by_best_degree(std::span<const double> dt, std::span<const double> error,
                                                         std::span<const double> uncertainty, int k);

}  // namespace polhode
