#include "experiments/common/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

report::verdict judge_order(const claim& c, double expected, const std::optional<order_fit>& fit, bool at_least) {
  auto v = judge_order(expected, fit, at_least);
  v.experiment = c.experiment, v.scheme = c.scheme, v.claim = c.text;
  return v;
}

report::verdict judge_order(double expected, const std::optional<order_fit>& fit, bool at_least) {
  report::verdict v{.expected = expected};
  if (!fit) {
    v.reason = "fewer than four usable levels";
    return v;
  }
  v.estimate = fit->order;
  v.low = fit->low;
  v.high = fit->high;
  v.kind = judge(expected, fit->low, fit->high, order_margin);
  if (at_least && fit->settled && v.kind != verdict_kind::holds && fit->low >= expected - order_margin) {
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
      fit->settled && judge(expected, fit->finest.low, fit->finest.high, order_margin) == verdict_kind::refuted;
  const bool nearing = gap_to(expected, fit->finest.low, fit->finest.high) < gap_to(expected, fit->low, fit->high);
  if (v.kind == verdict_kind::refuted && !lasting && nearing) {
    v.kind = verdict_kind::inconclusive;
    v.reason += fmt::format(", but the slope still nears the claim: [{:.3f}, {:.3f}] between the two finest levels",
                            fit->finest.low, fit->finest.high);
  }
  return v;
}

report::verdict judge_distance(const claim& c, const interval_estimate& d, double bound, const std::string& reason) {
  auto v = judge_distance(d, bound, reason);
  v.experiment = c.experiment, v.scheme = c.scheme, v.claim = c.text;
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

report::measurement measured(const series& s, std::optional<double> dt, double value, std::optional<double> low,
                             std::optional<double> high) {
  report::measurement m;
  m.experiment = s.experiment;
  m.scheme = s.scheme;
  m.quantity = s.quantity;
  m.observable = s.observable;
  m.unit = s.unit;
  m.method = s.method;
  if (dt) m.set_over({report::step_size, *dt, "time"});
  m.value = value;
  m.low = low;
  m.high = high;
  if (!std::isfinite(value)) {
    m.value = m.low = m.high = std::nullopt;
    m.status = "not finite";
  }
  return m;
}

void record_fit(report::results& out, const series& s, const std::optional<order_fit>& fit,
                std::vector<report::measurement> points) {
  if (fit) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i].used = fit->used[i];
    out.fits.push_back({s.experiment, s.scheme, s.quantity, s.observable, points.front().over, fit->order, fit->low,
                        fit->high, fit->prefactor, fit->rule});
  }
  out.measurements.insert(out.measurements.end(), points.begin(), points.end());
}

}  // namespace polhode
