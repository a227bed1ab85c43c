// Errors without sampling error as a power series of the step.
//
//   e(dt) = a_0 + a_1 dt + a_2 dt^2 + …        (Talay, Tubaro, Stoch. Anal. Appl. 8 (1990) 483)
//
// A scheme converges to the right law where a_0 = 0, and at order p where a_1 … a_(p-1) vanish as well. Each is found
// with a certainty, by a rule fixed in advance: for every degree d the polynomial through the d + 1 finest levels. The
// levels' uncertainties enter at their worst. What the series is cut off by is judged by what changes when the degree
// falls by one and when all levels move one coarser, the larger of the two. The degree with the least sum is taken.
#pragma once

#include <optional>
#include <span>

#include "statistics/order_fit.hpp"

namespace polhode {

/// One coefficient of the series: value +- certainty().
struct expansion_term {
  double value = 0;
  double propagated = 0;  ///< by the uncertainties of the levels
  double truncated = 0;   ///< by the terms that the polynomial leaves out
  int degree = 0;         ///< of the polynomial
  double certainty() const { return propagated + truncated; }
};

/// a_k from signed errors with uncertainties at decreasing dt; levels that are not finite are left out. Empty where
/// fewer than max(k, 1) + 2 are left.
std::optional<expansion_term> expansion_coefficient(std::span<const double> dt, std::span<const double> error,
                                                    std::span<const double> uncertainty, int k);

/// The order as the finest levels show it, in a fit of the four finest with |error| >= clear * uncertainty: the slope
/// between the last two. Its interval reaches one and a half times as far as the slope last changed, or half that of
/// the change before (a series makes each change half the one before), and by the uncertainties. It has settled where
/// the first part is at most 0.05. Empty where fewer than four levels are clear.
std::optional<order_fit> fit_finest_order(std::span<const double> dt, std::span<const double> error,
                                          std::span<const double> uncertainty, double clear);

}  // namespace polhode
