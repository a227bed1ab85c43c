// SPDX-License-Identifier: Apache-2.0
// What a table of exact errors says of its scheme.
//
// Where increments far out change the law, it is refuted at once. Else "order p" has three parts, each of every column:
// the limit a_0 at dt = 0 vanishes, so do a_1 … a_(p-1), and the slope of the finest levels is p or more
// (statistics/orders/power_series.hpp, finest_order.hpp). A limit vanishes where its interval meets what a
// ten-thousandth of the noise or of the dissipation would move; and the limits must be certain enough for a thousandth
// of either to be seen, or nothing is concluded.
#pragma once

#include <optional>
#include <vector>

#include "experiments/laws/transfer_report.hpp"
#include "statistics/orders/power_series.hpp"

namespace polhode {

// What is found in the columns of a table of exact errors, each by itself: slope, limit at dt = 0 and terms below the
// claimed order (statistics/orders/power_series.hpp, finest_order.hpp), and how certain these are.

inline constexpr double noticed_share = 1e-3;     ///< of noise or dissipation: a defect of that size must be seen
inline constexpr double tolerated_share = 1e-4;   ///< of either: a limit that stands for less is none
inline constexpr double resolved = 50;            ///< times its uncertainty: an error that a fit may use
inline constexpr double negligible_error = 1e-9;  ///< of the observable's size

struct column_finding {
  std::optional<order_fit> fit;       ///< of its resolved levels
  std::vector<expansion_term> terms;  ///< a_0, a_1, … below the claimed order; fewer where there are too few levels
  bool finest_is_resolved = false;    ///< of its uncertainty and of that of the limit
  bool approaches = false;  ///< how fast it nears its own limit, whatever that is, is known, or as good as reached
};
std::vector<column_finding> find_columns(const order_question&, double expected, const error_table&);

/// Of the columns' scales: what the limit of any column may be and still count as zero.
double tolerated_limit(const std::vector<error_column>&);

/// The least share of the noise (or of the dissipation) that would be seen in the limit of some column. None where a
/// thousandth of it moves no column by more than is negligible: then it is not asked for.
struct noticed {
  std::optional<double> noise, dissipation;
  double most() const;
};
noticed noticed_by(const std::vector<error_column>&, const std::vector<column_finding>&);

/// Do intervals have to become narrower for a verdict? By their widths, wherever they lie: a column does not yet show
/// how it nears its own limit, its slope is less certain than the margin, or the limits are not certain enough for want
/// of terms of the series.
bool too_wide(const order_question&, double expected, const error_table&);

}  // namespace polhode
