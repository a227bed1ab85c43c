// SPDX-License-Identifier: Apache-2.0
// What the paths of one scheme tell: its order in mean square, how strongly it feels Levy areas, and whether its limit
// is the true solution.
#pragma once

#include <span>

#include "experiments/common/path_limit.hpp"
#include "experiments/common/recorder.hpp"
#include "statistics/multipliers.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// Fine cells in the finest step.
inline constexpr int fine_per_step = 32;

/// One scheme over its levels.
struct strong_question {
  const context& c;
  const scheme_entry& scheme;
  std::span<const double> dt;
  double claimed() const;  ///< strong order on the scene's noise
};

/// What is found at the end of a batch.
struct strong_finding {
  std::optional<order_fit> fit;
  interval_estimate leading;  ///< coefficient of the mean square error at the claimed order
  path_limit limit;
  multiplier areas;
};

strong_finding find_order(const strong_question&, const path_record&, const noise_effect&);

/// By widths alone: of the order, of what is left as dt -> 0, and of the leading coefficient, whose unit is the whole
/// mean square error at the finest dt. Without a fit more paths would not help.
bool tight(const strong_question&, const squared_errors&, const strong_finding&);

/// The mean square error over dt, and the verdict on its order.
void report_order(const strong_question&, const squared_errors&, const strong_finding&, recorder&);

/// How strongly noise, dissipation, time and Levy areas are felt, and the verdict on the limit.
void report_limit(const strong_question&, const std::vector<direction>&, const strong_finding&, recorder&);

}  // namespace polhode
