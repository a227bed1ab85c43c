// SPDX-License-Identifier: Apache-2.0
#include "comparison/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace polhode {
namespace {

using report::change;
using report::change_kind;
using report::comparison;
using report::measurement;
using report::results;

constexpr double level = 0.05, exact_agreement = 1e-9;

/// Coordinates as printed, so that the last bit of a quotient makes no new row, in whatever order.
using row_key = std::tuple<report::series_id, std::set<std::string>, std::string>;
row_key row_of(const measurement& m) {
  std::set<std::string> at;
  for (const auto& c : m.at) at.insert(fmt::format("{} = {:.12g}", c.name, c.value));
  return {m.series(), at, m.method};
}

bool sampled(const measurement& m) { return m.method == "sampled"; }
bool timed(const measurement& m) { return m.method == "timed"; }
bool has_interval(const measurement& m) { return m.low || m.high; }

struct pair_of_rows {
  const measurement &before, &after;
};

/// Without copies, whose method is the experiment that they come from: they are judged there.
std::vector<pair_of_rows> pairs(const results& before, const results& after) {
  std::map<row_key, const measurement*> old;
  for (const auto& m : before.measurements) old.emplace(row_of(m), &m);
  std::set<std::string> experiments;
  for (const auto& e : after.experiments) experiments.insert(e.name);
  std::vector<pair_of_rows> out;
  for (const auto& m : after.measurements) {
    const auto found = old.find(row_of(m));
    if (found != old.end() && !experiments.contains(m.method)) out.push_back({*found->second, m});
  }
  return out;
}

/// Of an interval with one end its reach beyond the value.
double half_width(const measurement& m) {
  if (m.low && m.high) return (*m.high - *m.low) / 2;
  if (!m.value) return 0;
  return m.high ? std::max(0.0, *m.high - *m.value) : m.low ? std::max(0.0, *m.value - *m.low) : 0;
}

/// Drawn at random, and nobody knows how much that moves it.
bool of_unknown_noise(const pair_of_rows& p) {
  return sampled(p.after) && p.before.value && p.after.value && !(has_interval(p.before) && has_interval(p.after));
}

bool beyond_noise(const pair_of_rows& p, double z) {
  const double a = *p.before.value, b = *p.after.value;
  const double u = half_width(p.before), v = half_width(p.after);
  const double rounding = exact_agreement * std::max(std::fabs(a), std::fabs(b));
  if (!sampled(p.after)) return std::fabs(b - a) > u + v + rounding;
  return std::fabs(b - a) > z / 1.96 * std::hypot(u, v) + rounding;
}

change row_change(const pair_of_rows& p) {
  const auto& [before, after] = p;
  std::string what = after.quantity;
  if (!after.observable.empty()) what += " of " + after.observable;
  for (const auto& c : after.at)
    if (c.name != report::step_size) what += fmt::format(", {} = {:.12g}", c.name, c.value);
  return {change_kind::different,
          after.experiment,
          after.scheme,
          what,
          after.dt(),
          before.value,
          before.low,
          before.high,
          after.value,
          after.low,
          after.high,
          {},
          {}};
}

std::string missing_text(const measurement& m) { return m.value ? "" : m.status == "ok" ? "no value" : m.status; }

}  // namespace

void compare_numbers(const results& before, const results& after, comparison& out) {
  const auto rows = pairs(before, after);
  std::set<report::series_id> errors;
  for (const auto* r : {&before, &after})
    for (const auto& f : r->fits) errors.insert(f.series());
  const auto n = std::ranges::count_if(rows, [](const auto& p) { return sampled(p.after) && !of_unknown_noise(p); });
  const double z =
      boost::math::quantile(boost::math::normal(), 1 - level / 2 / static_cast<double>(std::max<long>(n, 1)));
  for (const auto& p : rows) {
    if (timed(p.after)) continue;  // timings.hpp
    ++(of_unknown_noise(p) ? out.without_interval : out.numbers);
    if (of_unknown_noise(p)) continue;
    auto found = row_change(p);
    const bool error = errors.contains(p.after.series());
    if (p.before.value && p.after.value) {
      if (!beyond_noise(p, z)) continue;
      if (error) found.kind = *p.after.value > *p.before.value ? change_kind::worse : change_kind::better;
    } else {
      if (p.before.value.has_value() == p.after.value.has_value()) continue;
      found.text_before = missing_text(p.before);
      found.text_after = missing_text(p.after);
      if (error) found.kind = p.before.value ? change_kind::worse : change_kind::better;
    }
    out.changes.push_back(found);
  }
}

}  // namespace polhode
