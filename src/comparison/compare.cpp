// SPDX-License-Identifier: Apache-2.0
#include "comparison/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "comparison/timings.hpp"
#include "reports/model/comparison.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/finite.hpp"
#include "reports/model/results.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

// Which numbers have changed beyond noise?

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

/// Drawn at random, and nobody knows how much that moves it.
bool of_unknown_noise(const pair_of_rows& p) {
  return is_sampled(p.after) && p.before.value && p.after.value && !(has_interval(p.before) && has_interval(p.after));
}

bool beyond_noise(const pair_of_rows& p, double z) {
  const double a = *p.before.value, b = *p.after.value;
  const double u = half_width(p.before).value_or(0), v = half_width(p.after).value_or(0);
  const double rounding = exact_agreement * std::max(std::fabs(a), std::fabs(b));
  if (!is_sampled(p.after)) return std::fabs(b - a) > u + v + rounding;
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

/// Appends the numbers that have changed, by the rules of compare.hpp, and counts those that were compared.
void compare_numbers(const results& before, const results& after, comparison& out) {
  const auto rows = pairs(before, after);
  std::set<report::series_id> errors;
  for (const auto* r : {&before, &after})
    for (const auto& f : r->fits) errors.insert(f.series());
  const auto n = std::ranges::count_if(rows, [](const auto& p) { return is_sampled(p.after) && !of_unknown_noise(p); });
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

// Which claims are decided otherwise?

using report::verdict_kind;

change_kind kind_of(verdict_kind before, verdict_kind after) {
  if (after == verdict_kind::refuted) return change_kind::worse;
  if (before == verdict_kind::refuted || after == verdict_kind::holds) return change_kind::better;
  return before == verdict_kind::holds ? change_kind::unsure : change_kind::different;
}

/// Appends the claims whose verdict has changed, and those that held and are no longer made of an experiment and scheme
/// that were run again; counts those that were compared.
void compare_claims(const results& before, const results& after, comparison& out) {
  using key = std::tuple<std::string, std::string, std::string>;
  const auto key_of = [](const report::verdict& v) { return key{v.experiment, v.scheme, v.claim}; };
  std::map<key, const report::verdict*> now;
  for (const auto& v : after.verdicts) now.emplace(key_of(v), &v);
  std::set<std::string> experiments, schemes;
  for (const auto& e : after.experiments) experiments.insert(e.name);
  for (const auto& s : after.schemes) schemes.insert(s.name);
  for (const auto& v : before.verdicts) {
    const auto found = now.find(key_of(v));
    change c{change_kind::unsure, v.experiment, v.scheme, v.claim, {}, v.estimate, v.low, v.high, {}, {}, {}, {}, {}};
    c.text_before = name_of(v.kind);
    if (found == now.end()) {
      // What was not asked this time has not changed.
      if (!experiments.contains(v.experiment) || (!v.scheme.empty() && !schemes.contains(v.scheme))) continue;
      c.text_after = "not claimed";
      if (v.kind == verdict_kind::holds) out.changes.push_back(c);
      continue;
    }
    ++out.claims;
    const auto& w = *found->second;
    if (w.kind == v.kind) continue;
    c.kind = kind_of(v.kind, w.kind);
    c.text_after = name_of(w.kind);
    c.after = w.estimate;
    c.after_low = w.low;
    c.after_high = w.high;
    out.changes.push_back(c);
  }
}

std::string to_come_of(const results& r) {
  return r.to_come.empty() ? "nothing" : fmt::format("{}", fmt::join(r.to_come, ", "));
}

/// What differs between the runs themselves.
void compare_settings(const results& before, const results& after, comparison& out) {
  const auto& a = before.provenance;
  const auto& b = after.provenance;
  const auto note = [&](std::string_view what, const auto& x, const auto& y) {
    if (x != y) out.settings.push_back(fmt::format("{}: {}, now {}", what, x, y));
  };
  note("version", a.version, b.version);
  note("commit", a.commit, b.commit);
  note("compiler", a.compiler, b.compiler);
  note("flags", a.flags, b.flags);
  note("processor", a.cpu, b.cpu);
  note("instruction set", a.isa, b.isa);
  note("generator", a.generator, b.generator);
  note("threads", a.threads, b.threads);
  note("seed", a.seed, b.seed);
  note("effort", a.effort, b.effort);
  note("unfinished, still to come", to_come_of(before), to_come_of(after));
  if (a.cpu != b.cpu || a.isa != b.isa || a.compiler != b.compiler || a.flags != b.flags)
    out.timings_left_out = "processor, instruction set, compiler or flags differ";
}

}  // namespace

void check_same_scene(const report::scene& a, const report::scene& b) {
  const auto differ = [&](std::string_view key) {
    throw input_error(
        fmt::format("the two results are of different scenes ({} differs: '{}' and '{}'); accepted: two "
                    "results of one scene",
                    one_line(key, 60), one_line(a.name, 60), one_line(b.name, 60)));
  };
  if (a.system != b.system) differ("system");
  for (const auto& p : a.parameters) {
    const auto other = std::ranges::find(b.parameters, p.name, &report::parameter::name);
    if (other == b.parameters.end() || !(*other == p)) differ(p.name);
  }
  for (const auto& p : b.parameters)
    if (std::ranges::find(a.parameters, p.name, &report::parameter::name) == a.parameters.end()) differ(p.name);
  if (a.momentum != b.momentum) differ("momentum");
  if (a.horizon != b.horizon) differ("horizon");
}

comparison compare(const results& before, const results& after) {
  check_same_scene(before.scene, after.scene);
  comparison out;
  out.scene = after.scene.name;
  compare_settings(before, after, out);
  compare_claims(before, after, out);
  compare_numbers(before, after, out);
  compare_timings(before, after, out);
  std::ranges::stable_sort(out.changes, {}, &change::kind);
  return out;
}

}  // namespace polhode
