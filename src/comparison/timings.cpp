// SPDX-License-Identifier: Apache-2.0
#include "comparison/timings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <utility>

#include "comparison/cost_changes.hpp"

namespace polhode {
namespace {

using report::results;

constexpr double false_alarms = 0.01;      // of a comparison
constexpr std::size_t fewest_schemes = 5;  // that have something in common

double two_sided(double level) { return boost::math::quantile(boost::math::normal(), 1 - level / 2); }

std::string percent(double log_change) { return fmt::format("{:+.1f} %", 100 * std::expm1(log_change)); }

report::change change_of(const std::string& scheme, const std::string& what, double median, double half) {
  report::change out;
  out.experiment = "work_precision";
  out.scheme = scheme;
  out.what = what;
  out.before = 1;
  out.after = std::exp(median);
  out.after_low = std::exp(median - half);
  out.after_high = std::exp(median + half);
  return out;
}

/// One line a scheme: its costs with noise, or without, or both.
void tell_moved(const std::string& scheme, const cost_group* noisy, const cost_group* still, report::comparison& out) {
  const auto moved = [](const cost_group* g) { return g && g->moved(); };
  if (!moved(noisy) && !moved(still)) return;
  const auto& main = moved(noisy) ? *noisy : *still;
  std::string what = "cost of a step against the yardstick";
  if (!moved(noisy)) what += ", without noise";
  what += fmt::format(", the median of {} dt", main.rows.size());
  if (moved(noisy) && moved(still)) what += fmt::format(" (without noise {})", percent(still->median));
  out.changes.push_back(change_of(scheme, what, main.median, main.threshold));
}

/// Costs that have moved otherwise than their scheme's, the farthest with their number.
void tell_apart(const std::string& scheme, const cost_group& g, bool silent, double z, report::comparison& out) {
  const double least = apart + g.strain;
  const cost_change* farthest = nullptr;
  int count = 0;
  for (const auto& r : g.rows) {
    const double distance = std::fabs(r.change - g.median);
    if (!(distance > least + z * r.error)) continue;
    ++count;
    if (!farthest || distance > std::fabs(farthest->change - g.median)) farthest = &r;
  }
  if (!farthest) return;
  auto found =
      change_of(scheme,
                fmt::format("cost of a step against the yardstick{}, apart from the other dt{}",
                            silent ? ", without noise" : "", count > 1 ? fmt::format(", and {} more", count - 1) : ""),
                farthest->change, least + z * farthest->error);
  found.dt = farthest->dt;
  out.changes.push_back(found);
}

std::vector<double> medians_of(const std::vector<cost_group*>& groups) {
  std::vector<double> out;
  for (const auto* g : groups) out.push_back(g->median);
  return out;
}

/// What all schemes have in common is one cause: taken out of each, and told once if it is large.
void take_out_common(std::map<group_key, cost_group>& groups, double state, report::comparison& out) {
  const double least = of_all + state;
  bool told = false;
  for (const bool silent : {false, true}) {
    const auto same = of_kind(groups, silent);
    if (same.size() < fewest_schemes) continue;
    const double common = median_of(medians_of(same));
    for (auto* g : same) g->take_out(common);
    if (std::fabs(common) <= least || std::exchange(told, true)) continue;
    out.changes.push_back(change_of("",
                                    fmt::format("cost of a step against the yardstick{}, common to {} schemes",
                                                silent ? ", without noise" : "", same.size()),
                                    common, least));
  }
}

void note_state(const std::map<group_key, cost_group>& groups, const yardstick& a, const yardstick& b,
                report::comparison& out) {
  double least = 0;
  bool strained = false;
  for (const auto& [_, g] : groups) {
    strained = strained || g.strain > between_runs;
    least = std::max(least, g.threshold);
  }
  if (strained)
    out.settings.push_back(fmt::format(
        "the machine's state: the yardstick took {:.3g} ns (a quarter of them above {:.3g}), now {:.3g} ({:.3g}); "
        "changes of cost below {:.0f} % are not told",
        a.ns, a.high, b.ns, b.high, 100 * std::expm1(least)));
}

}  // namespace

void compare_timings(const results& before, const results& after, report::comparison& out) {
  const auto timed = [](const results& r) { return std::ranges::any_of(r.measurements, is_cost); };
  if (!out.timings_left_out.empty() || !timed(before) || !timed(after)) return;
  const auto a = yardstick_of(before), b = yardstick_of(after);
  if (!a || !b) {
    out.timings_left_out =
        fmt::format("{} has no yardstick beside its timings", a ? "the later run" : "the earlier run");
    return;
  }
  auto groups = groups_of(before, after, std::log(b->ns / a->ns));
  for (const auto& [_, g] : groups) out.timings += g.rows.size();
  const double per_group = two_sided(false_alarms / static_cast<double>(std::max<std::size_t>(1, groups.size())));
  const double per_row = two_sided(false_alarms / static_cast<double>(std::max<std::size_t>(1, out.timings)));
  for (auto& [_, g] : groups) judge(g, per_group);
  const double state = difference_of_state(*a, *b);
  take_out_common(groups, state, out);
  widen(groups, state);
  note_state(groups, *a, *b, out);
  for (auto& [key, g] : groups) {
    const auto& [scheme, silent] = key;
    const auto other = groups.find({scheme, !silent});
    const auto* twin = other == groups.end() ? nullptr : &other->second;
    if (!silent || !twin) tell_moved(scheme, silent ? twin : &g, silent ? &g : twin, out);
    tell_apart(scheme, g, silent, per_row, out);
  }
}

}  // namespace polhode
