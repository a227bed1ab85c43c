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
  report::verdict v{"modified", t.scheme, what.claim, 0.0, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (t.dt.size() < static_cast<std::size_t>(order) + 2) {
    v.reason = "too few step sizes";
    return v;
  }
  double widest = 0, clearest = 0;
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
      const double clear = std::fabs(at) / std::max(half, 1e-300);
      if (clear > 1 ? clear <= clearest : clearest > 1 || half <= widest) continue;
      (clear > 1 ? clearest : widest) = clear > 1 ? clear : half;
      v.estimate = at;
      v.low = at - half;
      v.high = at + half;
      v.reason = fmt::format("of {} at order dt^{}: {:.2e} [{:.1e}, {:.1e}] of its size",
                             averages.names[static_cast<std::size_t>(i)], power, at, at - half, at + half);
    }
  }
  v.kind = clearest > 1       ? report::verdict_kind::refuted
           : widest <= narrow ? report::verdict_kind::holds
                              : report::verdict_kind::inconclusive;
  return v;
}

}  // namespace

void report_convergence(const converging_numbers& what, const error_table& t, Eigen::Index first, int order,
                        report::results& out) {
  if (what.exact.count() == 0) return;
  for (Eigen::Index i = 0; i < what.exact.count(); ++i) {
    const auto& name = what.exact.names[static_cast<std::size_t>(i)];
    std::vector<report::measurement> points;
    std::vector<double> clear;
    const series s{"modified", t.scheme, what.quantity, name, "", "transfer"};
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      const double error = std::fabs(t.error[level][first + i]),
                   u = t.uncertainty[level][first + i] + what.exact.uncertainty[i];
      points.push_back(measured(s, t.dt[level], error, std::max(0.0, error - u), error + u));
      clear.push_back(error > 50 * u ? error : std::numeric_limits<double>::quiet_NaN());
    }
    record_fit(out, s, fit_order(t.dt, clear, 0), std::move(points));
  }
  out.verdicts.push_back(judge(what, t, first, order));
}

}  // namespace polhode
