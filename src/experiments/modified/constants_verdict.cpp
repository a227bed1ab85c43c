// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/constants_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace polhode {
namespace {

constexpr double narrow = 0.01;   // of the largest constant
constexpr double natural = 1e-2;  // of rate^order: a constant below that is small

double half_of(const interval_estimate& e) { return (e.high - e.low) / 2; }

/// The difference of two intervals, which contains zero where they meet.
interval_estimate difference(const interval_estimate& measured, const interval_estimate& predicted) {
  return {measured.value - predicted.value, measured.low - predicted.high, measured.high - predicted.low};
}
series_coefficient difference(const leading_constant& c) {
  return {difference(c.measured.sharp, c.predicted), difference(c.measured.sure, c.predicted)};
}

bool excludes_zero(const interval_estimate& e) { return e.low > 0 || e.high < 0; }

std::string shown(const interval_estimate& e) { return fmt::format("{:.5g} [{:.5g}, {:.5g}]", e.value, e.low, e.high); }

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
                            shown(found), sure ? "" : " by one rule of two: finer steps would tell"));
}

std::string told(const leading_constant& c, int order, std::size_t observables) {
  return fmt::format("{}: {} times dt^{} measured, {} predicted by one step; {} observables", c.observable,
                     shown(c.measured.sharp), order, shown(c.predicted), observables);
}

}  // namespace

report::verdict judge_constants(const std::vector<leading_constant>& constants, int order, double rate) {
  if (constants.empty()) return {.reason = fmt::format("too few step sizes for a coefficient of dt^{}", order)};
  if (const auto there = not_zero(constants)) return judge_below(*there);
  const auto largest = std::ranges::max(
      constants, {}, [](const leading_constant& one) { return std::fabs(one.predicted.value) / one.size; });
  const double allowed =
      narrow * std::max(std::fabs(largest.predicted.value) / largest.size, natural * std::pow(rate, order));
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

}  // namespace polhode
