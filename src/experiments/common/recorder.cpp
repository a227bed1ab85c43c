// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/recorder.hpp"

#include <cmath>
#include <utility>

namespace polhode {

report::measurement row_of(const quantity& what, double value, std::optional<double> low, std::optional<double> high) {
  report::measurement m{.quantity = what.name, .observable = what.observable, .unit = what.unit, .method = what.method};
  if (!std::isfinite(value)) {
    m.status = "not finite";
    return m;
  }
  m.value = value;
  m.low = low;
  m.high = high;
  return m;
}

report::coordinate at_dt(double dt) { return {report::step_size, dt, "time"}; }

void curve::add(double x, double value, std::optional<double> low, std::optional<double> high) {
  points.push_back({x, value, low, high});
}

void curve::add(double x, const interval_estimate& m) { add(x, m.value, m.low, m.high); }

recorder::recorder(std::string_view experiment, std::string_view scheme, report::results& out)
    : experiment_(experiment), scheme_(scheme), out_(&out) {}

report::series_id recorder::id(const quantity& what, std::string_view over) const {
  return {experiment_, scheme_, what.name, what.observable, std::string(over)};
}

report::series_id recorder::row(report::measurement m) {
  m.experiment = experiment_;
  m.scheme = scheme_;
  auto id = m.series();
  out_->measurements.push_back(std::move(m));
  return id;
}

report::series_id recorder::value(const quantity& what, double value, std::optional<double> low,
                                  std::optional<double> high) {
  return row(row_of(what, value, low, high));
}

report::series_id recorder::value(const quantity& what, const interval_estimate& m) {
  return value(what, m.value, m.low, m.high);
}

report::series_id recorder::value(const quantity& what, const report::coordinate& over, double value,
                                  std::optional<double> low, std::optional<double> high) {
  auto m = row_of(what, value, low, high);
  m.set_over(over);
  return row(std::move(m));
}

report::series_id recorder::value(const quantity& what, const report::coordinate& over, const interval_estimate& m) {
  return value(what, over, m.value, m.low, m.high);
}

report::series_id recorder::series(const curve& c, const std::optional<order_fit>& found) {
  auto of = id(c.what, c.over);
  if (found) fit(of, found->order, found->low, found->high, found->prefactor, found->rule);
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const auto& p = c.points[i];
    auto m = row_of(c.what, p.value, p.low, p.high);
    m.at = c.at;
    m.set_over({c.over, p.at, c.unit});
    if (m.value) m.status = p.status;
    m.used = found ? found->used[i] : p.used;
    row(std::move(m));
  }
  return of;
}

void recorder::fit(const report::series_id& s, double order, double low, double high, double prefactor,
                   std::string rule) {
  fits_.push_back(out_->fits.size());
  out_->fits.push_back(
      {s.experiment, s.scheme, s.quantity, s.observable, s.over, order, low, high, prefactor, std::move(rule)});
}

void recorder::verdict(std::string claim, report::verdict v, const std::vector<report::series_id>& evidence) {
  v.experiment = experiment_;
  v.scheme = scheme_;
  v.claim = std::move(claim);
  v.evidence.insert(v.evidence.end(), evidence.begin(), evidence.end());
  verdicts_.push_back(out_->verdicts.size());
  out_->verdicts.push_back(std::move(v));
}

void recorder::remark(const std::string& text) {
  for (const auto i : fits_) out_->fits[i].rule += "; " + text;
  if (!fits_.empty()) return;
  for (const auto i : verdicts_) out_->verdicts[i].reason += "; " + text;
}

}  // namespace polhode
