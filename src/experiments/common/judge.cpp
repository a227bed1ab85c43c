// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics/multipliers.hpp"

namespace polhode {

using report::verdict_kind;

verdict_kind judge(double expected, double low, double high, double margin) {
  if (!std::isfinite(low) || !std::isfinite(high)) return verdict_kind::inconclusive;
  if (low >= expected - margin && high <= expected + margin) return verdict_kind::holds;
  if (low > expected + margin || high < expected - margin) return verdict_kind::refuted;
  return verdict_kind::inconclusive;
}

namespace {

/// How far an interval lies from an expected order and its margin.
double gap_to(double expected, double low, double high) {
  return std::max({0.0, low - expected - order_margin, expected - order_margin - high});
}

}  // namespace

report::verdict judge_order(double expected, const std::optional<order_fit>& fit, bool at_least) {
  report::verdict v{.expected = expected};
  if (!fit) {
    v.reason = "fewer than four usable levels";
    return v;
  }
  v.estimate = fit->order;
  v.low = fit->low;
  v.high = fit->high;
  if (std::isnan(expected)) {
    v.expected.reset();
    v.kind = verdict_kind::skipped;
    v.reason = fmt::format("not claimed; measured: order {:.3f} [{:.3f}, {:.3f}]", fit->order, fit->low, fit->high);
    return v;
  }
  v.kind = judge(expected, fit->low, fit->high, order_margin);
  if (at_least && fit->asymptotic && v.kind != verdict_kind::holds && fit->low >= expected - order_margin) {
    v.kind = verdict_kind::holds;
    v.reason = fmt::format("order {:.3f} [{:.3f}, {:.3f}]: faster on this scene than the {:g} claimed", fit->order,
                           fit->low, fit->high, expected);
    return v;
  }
  v.reason = fmt::format("order {:.3f} [{:.3f}, {:.3f}] against {:g} +- {:g}", fit->order, fit->low, fit->high,
                         expected, order_margin);
  if (at_least && fit->low > expected + order_margin) {
    v.kind = verdict_kind::inconclusive;  // steep before a zero crossing, perhaps
    v.reason += ": faster than claimed, and not settled";
    return v;
  }
  const bool lasting =
      fit->asymptotic && judge(expected, fit->finest.low, fit->finest.high, order_margin) == verdict_kind::refuted;
  const bool nearing = gap_to(expected, fit->finest.low, fit->finest.high) < gap_to(expected, fit->low, fit->high);
  if (v.kind == verdict_kind::refuted && !lasting && nearing) {
    v.kind = verdict_kind::inconclusive;
    v.reason += fmt::format(", but the slope still nears the claim: [{:.3f}, {:.3f}] between the two finest levels",
                            fit->finest.low, fit->finest.high);
  }
  return v;
}

report::verdict judge_sampled_order(double expected, const std::optional<order_fit>& fit) {
  if (!fit)
    return {.expected = expected, .reason = "fewer than four levels whose error is clear of the sampling error"};
  auto v = judge_order(expected, fit, true);
  if (v.kind == verdict_kind::skipped) return v;
  const double half = half_width(*fit), beyond = std::fabs(fit->order - expected) - order_margin;
  const double standard_errors = 1.96 * beyond / half;
  if (half > order_margin)
    v.reason = fmt::format("order {:.3f} [{:.3f}, {:.3f}]: wider than the margin of {:g}", fit->order, fit->low,
                           fit->high, order_margin);
  else if (v.kind == verdict_kind::refuted && standard_errors <= family_z)
    v.reason += fmt::format(", beyond the margin by {:.1f} standard errors, of which {:.1f} would refute",
                            standard_errors, family_z);
  else
    return v;
  v.kind = verdict_kind::inconclusive;
  return v;
}

report::verdict judge_distance(const interval_estimate& d, double bound, const std::string& reason) {
  report::verdict v{.expected = 0.0, .reason = reason};
  if (!std::isfinite(d.value)) return v;
  v.estimate = d.value;
  v.low = d.low;
  v.high = d.high;
  v.kind = d.high <= bound ? verdict_kind::holds : d.low > bound ? verdict_kind::refuted : verdict_kind::inconclusive;
  return v;
}

}  // namespace polhode
