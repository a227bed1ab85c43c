// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/modified_constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/undecided.hpp"
#include "sphere/uniqueness.hpp"
#include "statistics/orders/power_series.hpp"

namespace polhode {
namespace {

constexpr double narrow_constant = 0.01;  // of the largest constant
constexpr double natural = 1e-2;          // of rate^order: a constant below that is small

double half_of(const interval_estimate& e) { return (e.high - e.low) / 2; }

/// The difference of two intervals, which contains zero where they meet.
interval_estimate difference(const interval_estimate& measured, const interval_estimate& predicted) {
  return {measured.value - predicted.value, measured.low - predicted.high, measured.high - predicted.low};
}
series_coefficient difference(const leading_constant& c) {
  return {difference(c.measured.sharp, c.predicted), difference(c.measured.sure, c.predicted)};
}

bool excludes_zero(const interval_estimate& e) { return e.low > 0 || e.high < 0; }

std::string shown_interval(const interval_estimate& e) {
  return fmt::format("{:.5g} [{:.5g}, {:.5g}]", e.value, e.low, e.high);
}

/// How far from zero an interval's middle lies, in half-widths.
double far(const interval_estimate& e) { return std::fabs(e.low + e.high) / 2 / std::max(half_of(e), 1e-300); }

struct vanishing {
  const leading_constant* constant;
  std::size_t power;
  const series_coefficient& found() const { return constant->below[power]; }
};

/// A coefficient that has to vanish and does not: by both rules if there is such a one, else by one.
std::optional<vanishing> not_zero(const std::vector<leading_constant>& constants) {
  std::optional<vanishing> out;
  for (const auto& one : constants)
    for (std::size_t power = 0; power < one.below.size(); ++power) {
      const vanishing now{&one, power};
      if (!excludes_zero(now.found().sharp) || (out && !excludes_zero(now.found().sure))) continue;
      out = now;
      if (excludes_zero(now.found().sure)) return out;
    }
  return out;
}

report::verdict judged(report::verdict_kind kind, double expected, const interval_estimate& found, std::string reason) {
  return {.expected = expected,
          .estimate = found.value,
          .low = found.low,
          .high = found.high,
          .kind = kind,
          .reason = std::move(reason)};
}

report::verdict judge_below(const vanishing& there) {
  const bool sure = excludes_zero(there.found().sure);
  const auto& found = sure ? there.found().sure : there.found().sharp;
  return judged(sure ? report::verdict_kind::refuted : report::verdict_kind::inconclusive, 0, found,
                fmt::format("error of {} at order dt^{}: {}, not zero{}", there.constant->observable, there.power,
                            shown_interval(found), sure ? "" : " by one rule of two: finer steps would tell"));
}

std::string told(const leading_constant& c, int order, std::size_t observables) {
  return fmt::format("{}: {} times dt^{} measured, {} predicted by one step; {} observables", c.observable,
                     shown_interval(c.measured.sharp), order, shown_interval(c.predicted), observables);
}

constexpr int degree = 12, finer = 16;
constexpr const char *weak_constant = "leading constant of the weak error",
                     *bias_constant = "leading constant of the stationary bias";
constexpr std::array<double, 4> expansion_steps{1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128};  // of the fastest time scale

/// The interval of one rule, and the least that contains those of both.
series_coefficient of_both_rules(const interval_estimate& sharp, const std::optional<expansion_term>& other) {
  series_coefficient out{sharp, sharp};
  if (!other) return out;
  out.sure.low = std::min(sharp.low, other->value - other->certainty());
  out.sure.high = std::max(sharp.high, other->value + other->certainty());
  return out;
}

std::vector<report::series_id> report_constants(const std::string& kind, const std::vector<leading_constant>& constants,
                                                recorder& record) {
  std::vector<report::series_id> written;
  for (const auto& one : constants) {
    const auto add = [&](const char* how, const interval_estimate& e) {
      written.push_back(record.value({fmt::format("{}, {}", kind, how), one.observable, "", "transfer"}, e));
    };
    add("measured", one.measured.sharp);
    add("predicted", one.predicted);
  }
  return written;
}

}  // namespace

report::verdict judge_constants(const std::vector<leading_constant>& constants, int order, double rate) {
  if (constants.empty()) return {.reason = fmt::format("too few step sizes for a coefficient of dt^{}", order)};
  if (const auto there = not_zero(constants)) return judge_below(*there);
  const auto largest = std::ranges::max(
      constants, {}, [](const leading_constant& one) { return std::fabs(one.predicted.value) / one.size; });
  const double allowed =
      narrow_constant * std::max(std::fabs(largest.predicted.value) / largest.size, natural * std::pow(rate, order));
  const auto by_distance = [](const leading_constant& one) { return far(difference(one).sure); };
  const auto by_width = [](const leading_constant& one) { return half_of(difference(one).sharp) / one.size; };
  const auto& farthest = *std::ranges::max_element(constants, {}, by_distance);
  const auto& widest = *std::ranges::max_element(constants, {}, by_width);
  const auto apart =
      std::ranges::find_if(constants, [](const leading_constant& one) { return excludes_zero(difference(one).sharp); });
  using enum report::verdict_kind;
  if (by_distance(farthest) > 1)
    return judged(refuted, farthest.predicted.value, farthest.measured.sure, told(farthest, order, constants.size()));
  const bool doubtful = apart != constants.end(), narrow_enough = by_width(widest) <= allowed;
  const auto& decisive = doubtful ? *apart : narrow_enough ? largest : widest;
  return judged(doubtful || !narrow_enough ? inconclusive : holds, decisive.predicted.value, decisive.measured.sharp,
                told(decisive, order, constants.size()) + (doubtful ? ", and disjoint by one rule of two" : ""));
}

std::vector<leading_constant> leading_constants(const exact_averages& averages, const error_table& t,
                                                Eigen::Index first, std::span<const interval_estimate> predicted,
                                                int order) {
  std::vector<leading_constant> out;
  if (t.dt.size() < static_cast<std::size_t>(order) + 3) return out;
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    std::vector<double> value, uncertainty;
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      value.push_back(t.error[level][first + i]);
      uncertainty.push_back(t.uncertainty[level][first + i]);
    }
    std::vector<series_coefficient> series;
    for (const auto& sharp : series_by_all_levels(t.dt, value, uncertainty, static_cast<std::size_t>(order) + 1))
      series.push_back(
          of_both_rules(sharp, series_term_by_best_degree(t.dt, value, uncertainty, static_cast<int>(series.size()))));
    const auto k = static_cast<std::size_t>(i);
    leading_constant c{averages.names[k], averages.size[i], series.back(), predicted[k], {}};
    series.pop_back();
    c.below = std::move(series);
    out.push_back(std::move(c));
  }
  return out;
}

void keep_affordable(const context& c, const std::vector<scheme_entry>& schemes, law_averages& averages,
                     report::results& out) {
  const auto degree_afforded = [](effort e) { return by_effort(e, 24.0, 48.0, 96.0); };
  const auto keep = [&](exact_averages& some, const std::string& reason, bool applies, const char* claim) {
    if (some.count() == 0 && !applies)
      out.skipped.push_back({"modified", "", fmt::format("{}: {}", claim, reason)});
    else if (some.count() == 0)
      leave_open(schemes, "modified", claim, reason, out);
    return some.count() > 0 && affords(c, schemes,
                                       {"modified", claim, "knowing the averages", "degrees of harmonics",
                                        static_cast<double>(some.degree), degree_afforded},
                                       out);
  };
  const bool noisy = c.subject.model->noise() != noise_class::none,
             one_law = noisy && no_unique_law(*c.subject.sphere()).empty();
  if (!keep(averages.at_horizon, averages.no_horizon, noisy, weak_constant)) averages.at_horizon = {};
  const bool bias = keep(averages.stationary, averages.no_law, one_law, bias_constant),
             variance = keep(averages.stationary, averages.no_law, one_law, variance_claim);
  if (!bias || !variance) averages.stationary = {};
}

void report_leading_constants(const context& c, const std::vector<scheme_entry>& schemes, const law_averages& averages,
                              const std::vector<error_table>& tables, const std::vector<int>& orders,
                              report::results& out) {
  if (averages.count() == 0) return;
  const double rate = fastest_rate(c.subject);
  std::vector<double> dt;
  for (const double share : expansion_steps) dt.push_back(share / rate);
  const expansion_frame coarse(c.subject, averages, degree, dt), fine(c.subject, averages, finer, dt);
  std::vector<std::vector<interval_estimate>> predicted(schemes.size());
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    predicted[k] = predicted_constants(c.subject, schemes[k], averages, coarse, fine, orders[k]);
  });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    recorder record("modified", tables[k].scheme, out);
    const std::span all(predicted[k]);
    const auto report = [&](const char* what, const exact_averages& kind, Eigen::Index before) {
      if (kind.count() == 0) return;
      const auto found = leading_constants(kind, tables[k], modified_columns::count + before,
                                           all.subspan(static_cast<std::size_t>(before)), orders[k]);
      const auto rows = report_constants(what, found, record);
      record.verdict(what, judge_constants(found, orders[k], rate), rows);
    };
    report(weak_constant, averages.at_horizon, 0);
    report(bias_constant, averages.stationary, averages.at_horizon.count());
  }
}

}  // namespace polhode
