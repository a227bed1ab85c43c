// SPDX-License-Identifier: Apache-2.0
#include "comparison/timings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode {
namespace {

using report::measurement;
using report::results;

// Costs of the steps of two runs, each in units of its run's yardstick: how they change, and from where on that is a
// change.

/// A cost at one dt, before and after, in units of the yardsticks: its change and the standard error of that.
struct cost_change {
  double dt, change, error;
};

/// The costs of one scheme, with noise or without it.
struct cost_group {
  std::vector<cost_change> rows;
  double median = 0, threshold = 0, strain = 0;
  bool moved() const { return std::fabs(median) > threshold; }
  void take_out(double common) {
    median -= common;
    for (auto& r : rows) r.change -= common;
  }
};

using group_key = std::tuple<std::string, bool>;  // scheme, without noise

struct yardstick {
  double ns, high;  ///< median, upper quartile
};

constexpr double quantile = 1.96;         // of the intervals
constexpr std::size_t fewest_others = 7;  // by whose scatter one is judged

bool without_noise(const measurement& m) { return m.observable == "energy_law"; }

/// Standard error of log(value).
double relative_error(const measurement& m) {
  if (!m.low || !m.high || !(*m.low > 0)) return 0;
  return std::log(*m.high / *m.low) / (2 * quantile);
}

double median_of(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::ranges::nth_element(x, middle);
  return *middle;
}

/// The standard deviation of normal values, by their median distance from their median.
double robust_deviation(std::vector<double> x) {
  const double middle = median_of(x);
  for (double& v : x) v = std::fabs(v - middle);
  return 1.4826 * median_of(std::move(x));
}

/// Three times the largest change but one (of seven that scatter evenly, one is that far ahead in two of a hundred
/// cases).
double scatter_of_others(const std::vector<cost_group*>& groups) {
  std::vector<double> size;
  for (const auto* g : groups) size.push_back(std::fabs(g->median));
  std::ranges::nth_element(size, size.begin() + 1, std::greater{});
  return 3 * size[1];
}

bool is_cost(const measurement& m) { return m.method == "timed" && m.quantity == "cost" && m.value && m.dt(); }

std::optional<yardstick> yardstick_of(const results& r) {
  for (const auto& m : r.measurements)
    if (m.quantity == "yardstick" && m.method == "timed" && m.value && *m.value > 0)
      return yardstick{*m.value, std::max(*m.value, m.high.value_or(*m.value))};
  return std::nullopt;
}

/// The larger of |log(b / a)| for the two numbers of a yardstick measures how the state of the machine differs.
double difference_of_state(const yardstick& a, const yardstick& b) {
  return std::max(std::fabs(std::log(b.ns / a.ns)), std::fabs(std::log(b.high / a.high)));
}

/// Costs are kept by scheme and noise; unit: log of how the yardstick has changed. A step is timed once, whatever kinds
/// of errors it is held against.
std::map<group_key, cost_group> groups_of(const results& before, const results& after, double unit) {
  using row_key = std::tuple<std::string, bool, std::string>;
  const auto key_of = [](const measurement& m) {
    return row_key{m.scheme, without_noise(m), fmt::format("{:.12g}", *m.dt())};
  };
  std::map<row_key, const measurement*> old, now;
  for (const auto& m : before.measurements)
    if (is_cost(m)) old.emplace(key_of(m), &m);
  for (const auto& m : after.measurements)
    if (is_cost(m)) now.emplace(key_of(m), &m);
  std::map<group_key, cost_group> out;
  for (const auto& [key, m] : now) {
    const auto found = old.find(key);
    if (found == old.end() || !(*found->second->value > 0) || !(*m->value > 0)) continue;
    out[{m->scheme, without_noise(*m)}].rows.push_back(
        {*m->dt(), std::log(*m->value / *found->second->value) - unit,
         std::hypot(relative_error(*m), relative_error(*found->second))});
  }
  return out;
}

/// Sets median and threshold, on a machine in one state; z: quantile.
void judge(cost_group& g, double z) {
  std::vector<double> changes, errors;
  for (const auto& r : g.rows) {
    changes.push_back(r.change);
    errors.push_back(r.error);
  }
  g.median = median_of(changes);
  const double n = static_cast<double>(g.rows.size()), of_median = 1.2533 / std::sqrt(n);
  const double scatter = robust_deviation(changes) * of_median, own = shared * median_of(errors);
  g.threshold = between_runs + z * std::hypot(scatter, own);
}

/// With noise or without.
std::vector<cost_group*> of_kind(std::map<group_key, cost_group>& groups, bool silent) {
  std::vector<cost_group*> out;
  for (auto& [key, g] : groups)
    if (std::get<1>(key) == silent) out.push_back(&g);
  return out;
}

/// Where the machine was in another state, schemes are slowed by different amounts: the strain, and the threshold with
/// it.
void widen(std::map<group_key, cost_group>& groups, double state) {
  for (const bool silent : {false, true}) {
    const auto same = of_kind(groups, silent);
    const double strain = same.size() < fewest_others ? state : std::min(state, scatter_of_others(same));
    for (auto* g : same) {
      g->strain = strain;
      g->threshold += strain;
    }
  }
}

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
