// SPDX-License-Identifier: Apache-2.0
// How strongly does a scheme feel Levy areas?
//
// With Y the true solution without the areas of level dt (the twin of experiments/common/driven_block.hpp), S = X - Y
// is what they do to a path there. A scheme that feels them 1 + eps times has the error eps S + O(dt); one that is not
// given them has eps = -1. What is of order dt is of odd degree in the increments of a step, where areas are of even,
// so that E[S.error]/dt = eps a + O(dt) and E|S|^2/dt = a + O(dt): both limits by a polynomial in dt, with weights
// fixed in advance. It sees eps to the first power, and beside terms of any size that fall faster; the mean square
// error has eps^2 dt beside the scheme's own dt^2.
#pragma once

#include <span>

#include "statistics/multipliers.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// Of each path and level: S.error and |S|^2.
struct area_response {
  squared_errors product, square;
};

/// dt: of all levels, coarsest first; of them the finest six are used, and at least four are needed. cells: of the
/// truth in the finest step, to one of which the limit is known. Not known where `a` is not resolved from zero, by the
/// same certainty as a strength: the noise commutes, or the drift hides its areas.
multiplier area_strength(std::span<const double> dt, const area_response&, int paths, int cells);

}  // namespace polhode
