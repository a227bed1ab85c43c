// SPDX-License-Identifier: Apache-2.0
// What is found in the columns of a table of exact errors, each by itself: slope, limit at dt = 0 and terms below the
// claimed order (statistics/orders/power_series.hpp, finest_order.hpp), and how certain these are.
#pragma once

#include <optional>
#include <vector>

#include "experiments/laws/transfer_report.hpp"
#include "statistics/orders/power_series.hpp"

namespace polhode {

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

}  // namespace polhode
