// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/converging_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/orders/power_series.hpp"

namespace polhode {
namespace {

constexpr double narrow = 1e-3;  // half-width, relative, at the coarsest dt

report::verdict judge(const converging_numbers& what, const error_table& t, Eigen::Index first, int order) {
  const auto& averages = what.exact;
  report::verdict v{.expected = 0.0};
  if (t.dt.size() < static_cast<std::size_t>(order) + 2) {
    v.reason = "too few step sizes";
    return v;
  }
  double widest = 0, farthest = 0;  // from zero, in half-widths
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    std::vector<double> value, uncertainty;
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      value.push_back(t.error[level][first + i] / averages.value[i]);
      uncertainty.push_back(t.uncertainty[level][first + i] / averages.value[i]);
    }
    const auto series = series_by_all_levels(t.dt, value, uncertainty, static_cast<std::size_t>(order));
    for (std::size_t power = 0; power < series.size(); ++power) {
      const double unit = std::pow(std::ranges::max(t.dt), static_cast<double>(power));
      const double common = power == 0 ? averages.uncertainty[i] / averages.value[i] : 0;  // to all levels
      const double half = unit * (series[power].high - series[power].low) / 2 + common, at = unit * series[power].value;
      const double far = std::fabs(at) / std::max(half, 1e-300);
      if (far > 1 ? far <= farthest : farthest > 1 || half <= widest) continue;
      (far > 1 ? farthest : widest) = far > 1 ? far : half;
      v.estimate = at;
      v.low = at - half;
      v.high = at + half;
      v.reason = fmt::format("of {} at order dt^{}: {:.2e} [{:.1e}, {:.1e}] of its size",
                             averages.names[static_cast<std::size_t>(i)], power, at, at - half, at + half);
    }
  }
  v.kind = farthest > 1       ? report::verdict_kind::refuted
           : widest <= narrow ? report::verdict_kind::holds
                              : report::verdict_kind::inconclusive;
  return v;
}

/// Over dt, with the order at which it falls.
report::series_id report_errors(const converging_numbers& what, const error_table& t, Eigen::Index first,
                                Eigen::Index i, recorder& record) {
  curve errors{{what.quantity, what.exact.names[static_cast<std::size_t>(i)], "", "transfer"}};
  std::vector<double> resolved;
  for (std::size_t level = 0; level < t.dt.size(); ++level) {
    const double error = std::fabs(t.error[level][first + i]),
                 u = t.uncertainty[level][first + i] + what.exact.uncertainty[i];
    errors.add(t.dt[level], error, std::max(0.0, error - u), error + u);
    resolved.push_back(error > 50 * u ? error : std::numeric_limits<double>::quiet_NaN());
  }
  return record.series(errors, fit_order(t.dt, resolved, 0));
}

}  // namespace

void report_convergence(const converging_numbers& what, const error_table& t, Eigen::Index first, int order,
                        recorder& record) {
  if (what.exact.count() == 0) return;
  std::vector<report::series_id> errors;
  for (Eigen::Index i = 0; i < what.exact.count(); ++i) errors.push_back(report_errors(what, t, first, i, record));
  record.verdict(what.claim, judge(what, t, first, order), errors);
}

}  // namespace polhode
