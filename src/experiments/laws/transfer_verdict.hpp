// SPDX-License-Identifier: Apache-2.0
// What a table of exact errors says of its scheme.
//
// Where increments far out change the law, it is refuted at once. Else "order p" has three parts, each of every column:
// the limit a_0 at dt = 0 vanishes, so do a_1 … a_(p-1), and the slope of the finest levels is p or more
// (statistics/orders/power_series.hpp, finest_order.hpp). A limit vanishes where its interval meets what a
// ten-thousandth of the noise or of the dissipation would move; and the limits must be certain enough for a thousandth
// of either to be seen, or nothing is concluded.
#pragma once

#include "experiments/laws/column_findings.hpp"

namespace polhode {

/// Do intervals have to become narrower for a verdict? By their widths, wherever they lie: a column does not yet show
/// how it nears its own limit, its slope is less certain than the margin, or the limits are not certain enough for want
/// of terms of the series.
bool too_wide(const order_question&, double expected, const error_table&);

}  // namespace polhode
