// SPDX-License-Identifier: Apache-2.0
// Are the leading constants of a scheme's errors after many steps those that one step predicts?
#pragma once

#include "experiments/modified/constants_verdict.hpp"
#include "experiments/modified/leading_constants.hpp"
#include "experiments/modified/modified_table.hpp"

namespace polhode {

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
