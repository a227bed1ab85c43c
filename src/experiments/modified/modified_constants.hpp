// SPDX-License-Identifier: Apache-2.0
// Are the leading constants of a scheme's errors after many steps those that one step predicts?
#pragma once

#include <string>
#include <vector>

#include "experiments/modified/leading_constants.hpp"
#include "experiments/modified/modified_table.hpp"
#include "reports/model/results.hpp"
#include "statistics/sample.hpp"

namespace polhode {

// The verdict on leading constants: those found in a scheme's errors against those that one step predicts.

/// A coefficient of the errors' power series, whose intervals are estimates of what extrapolation leaves out.
struct series_coefficient {
  interval_estimate sharp;  ///< by all levels
  interval_estimate sure;   ///< that of both rules (statistics/orders/power_series.hpp)
};

/// One average of a scheme: the constant found in its errors over dt, and the one predicted.
struct leading_constant {
  std::string observable;
  double size;  ///< of the observable
  series_coefficient measured;
  interval_estimate predicted;
  std::vector<series_coefficient> below;  ///< coefficients of dt^0 ... dt^(order - 1), which have to vanish
};

/// "leading constant of …": refuted where the intervals of an observable are disjoint, or a coefficient below dt^order
/// is not zero, by both rules; holds where all meet by the sharper one and are narrow: together below a hundredth of
/// the largest constant, or of a hundredth of rate^order; else inconclusive.
report::verdict judge_constants(const std::vector<leading_constant>&, int order, double rate);

/// Errors of the averages (columns `first` ... of the table) as power series in dt. Fewer than order + 3 levels: none.
std::vector<leading_constant> leading_constants(const exact_averages&, const error_table&, Eigen::Index first,
                                                std::span<const interval_estimate> predicted, int order);

/// Leaves those averages of which the claims of this experiment are affordable, and says why the others are not tried,
/// not decided, or do not apply.
void keep_affordable(const context&, const std::vector<scheme_entry>&, law_averages&, report::results&);

/// Verdicts and constants of all schemes, for both kinds of averages where they are known.
void report_leading_constants(const context&, const std::vector<scheme_entry>&, const law_averages&,
                              const std::vector<error_table>&, const std::vector<int>& orders, report::results&);

}  // namespace polhode
