// SPDX-License-Identifier: Apache-2.0
// A number of ours against a published one.
#pragma once

#include <string>

#include "reports/model/reproduction.hpp"
#include "statistics/sample.hpp"

namespace polhode {

/// Agrees where the interval of ours lies in published +- tolerance. why: where the tolerance comes from.
report::reproduced_number compared(std::string quantity, double published, double tolerance,
                                   const interval_estimate& ours, std::string why);
/// A number that is uncertain by so much.
interval_estimate within(double value, double uncertainty);

/// What was published is a bound: agrees where the interval of ours does not pass it.
report::reproduced_number compared_at_most(std::string quantity, double most, const interval_estimate& ours,
                                           std::string why);
report::reproduced_number compared_at_least(std::string quantity, double least, const interval_estimate& ours,
                                            std::string why);

/// Or two.
report::reproduced_number compared_between(std::string quantity, double least, double most,
                                           const interval_estimate& ours, std::string why);

/// A difference that is expected: the reason is put before the rest, and only where there is one.
report::reproduced_number explained_by(report::reproduced_number, const std::string& reason);

}  // namespace polhode
