// SPDX-License-Identifier: Apache-2.0
// Which levels take part in the fit of an order.
//
// The rule is fixed in advance: levels at the rounding floor and levels that are not finite are left out; of the rest
// the finest six are taken; the coarsest of these is left out as pre-asymptotic while it lies off the line through the
// others by more than 0.05 in log2 and more than three standard errors. At least four levels stay, or there is no fit.
#pragma once

#include <string>
#include <vector>

#include "statistics/orders/log_line.hpp"

namespace polhode {

inline constexpr std::size_t least_levels = 4;
inline constexpr int fitted_levels = 6;       ///< the most
inline constexpr double off_the_line = 0.05;  ///< in log2: more is curvature

struct level_choice {
  std::vector<log_level> finest, levels;  ///< that may take part, and that do: the last of them; from coarse to fine
  std::string rule;                       ///< what was left out, and why
};

/// The last of these levels, from coarse to fine, without the pre-asymptotic ones.
std::vector<log_level> asymptotic_part(std::vector<log_level>);

/// Of levels that are finite and above the floor; so many others are not.
level_choice choose_levels(std::vector<log_level>, std::size_t left_out_at_floor);

/// All of them: a growth law has no asymptotic part.
level_choice every_level(std::vector<log_level>);

}  // namespace polhode
