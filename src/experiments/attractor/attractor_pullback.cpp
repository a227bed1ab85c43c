// SPDX-License-Identifier: Apache-2.0
// Does the snapshot at time 0 stop changing when the same noise has acted for longer (pullback_changes.hpp)?
//
// Looks at one path are not independent, and intervals are over paths.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/attractor/pullback_changes.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "statistics/distributions.hpp"
#include "statistics/orders/level_choice.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

constexpr double span_time = 2.5;                  // in the time in which the area of a set shrinks by e
constexpr double least_standard_errors = 3;        // that a level must have above zero to be fitted
constexpr double most_path_steps = 1e8;            // of one scheme at quick effort
constexpr int least_paths = 24, most_paths = 288;  // the most where too few levels are resolved for a fit
constexpr int least_looks = 4, most_looks = 7;
constexpr const char* pullback_claim = "pullback converges";

/// The levels from the first on that are resolved: so far above zero.
int resolved_levels(const squared_errors& changes) {
  int n = 0;
  for (; n < changes.levels; ++n) {
    const auto m = level_mean(changes, n);
    if (!(m.mean > least_standard_errors * m.error)) break;
  }
  return n;
}

/// Over the first levels, those that are resolved and no fewer than a fit needs. Distances fall like exp(-rate T): the
/// mean squares over 2^-T in spans have the order 2 rate span / log 2.
std::optional<double> rate_at(const squared_errors& changes, double span) {
  const int levels = std::max(resolved_levels(changes), static_cast<int>(least_levels));
  squared_errors first{changes.paths, levels, {}};
  for (int path = 0; path < changes.paths; ++path)
    for (int i = 0; i < levels; ++i) first.values.push_back(changes.at(path, i));
  std::vector<double> abscissa;
  for (int i = 0; i < levels; ++i) abscissa.push_back(std::exp2(-1.0 - i));
  const auto power = power_of_means(abscissa, first);
  return power ? std::optional(std::numbers::ln2 / (2 * span) * *power) : std::nullopt;
}

/// The interval is over paths: each replicate has its own levels, as they are chosen by what was sampled.
std::optional<interval_estimate> rate_of(const squared_errors& changes, double span, std::uint64_t seed) {
  const auto rate = rate_at(changes, span);
  if (resolved_levels(changes) < static_cast<int>(least_levels) || !rate) return std::nullopt;
  std::vector<double> rates;
  for (int r = 0; r < bootstrap_replicates; ++r) {
    squared_errors drawn{changes.paths, changes.levels, {}};
    for (const int path : resample(seed, r, changes.paths))
      for (int i = 0; i < changes.levels; ++i) drawn.values.push_back(changes.at(path, i));
    if (const auto of_drawn = rate_at(drawn, span)) rates.push_back(*of_drawn);
  }
  const auto [low, high] = bootstrap_interval(std::move(rates), 0.95, changes.paths);
  return interval_estimate{*rate, low, high};
}

report::series_id report_changes(const squared_errors& changes, double span, recorder& record) {
  const auto root = [](double x) { return std::sqrt(std::max(0.0, x)); };
  const int resolved = resolved_levels(changes);
  const double t = student_t_quantile(0.975, changes.paths - 1);
  curve change{{"change of the snapshot", "density", "of the uniform density", "sampled"},
               "time T before the snapshot"};
  for (int i = 0; i < changes.levels; ++i) {
    const auto m = level_mean(changes, i);
    change.add((i + 1) * span, root(m.mean), root(m.mean - t * m.error), root(m.mean + t * m.error));
    change.points.back().used = i < resolved;
    if (i >= resolved) change.points.back().status = "not clear of zero";
  }
  return record.series(change);
}

report::verdict judge_rate(const std::optional<interval_estimate>& rate, double gap) {
  if (!rate) return {.reason = "the snapshot changes too little, or too irregularly, for a rate"};
  return {.estimate = rate->value,
          .low = rate->low,
          .high = rate->high,
          .kind = rate->low > 0    ? report::verdict_kind::holds
                  : rate->high < 0 ? report::verdict_kind::refuted
                                   : report::verdict_kind::inconclusive,
          .reason = fmt::format("the change falls like exp(-r T), r = {:.4f} in [{:.4f}, {:.4f}], above 0; one body "
                                "forgets its start at the rate {:.4f}",
                                rate->value, rate->low, rate->high, gap)};
}

void report_scheme(const squared_errors& changes, double span, double gap, std::uint64_t seed, recorder& record) {
  std::vector evidence{report_changes(changes, span, record)};
  const auto rate = rate_of(changes, span, seed);
  if (rate) evidence.push_back(record.value({"pullback rate", "", "per time", "sampled"}, *rate));
  record.verdict(pullback_claim, judge_rate(rate, gap), evidence);
}

}  // namespace

void report_pullback(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double span = -span_time / f.exponents.sum;
  pullback_plan plan{f.steps_in(span, f.dt), by_effort(c.effort, 24, 144, 144), by_effort(c.effort, 1, 2, 2),
                     by_effort(c.effort, least_looks, most_looks, most_looks)};
  const double most = affordable(c.effort, most_path_steps);
  const auto work = [&] {
    return 2.0 * static_cast<double>(plan.spans_run() * plan.steps) * plan.paths * plan.blocks * block_lanes;
  };
  while (work() > most && plan.looks > least_looks) --plan.looks;
  while (work() > most && plan.paths > least_paths) plan.paths /= 2;
  if (!affords(c, f.schemes,
               {"attractor", pullback_claim, "forgetting the start", "path-steps a scheme", work(),
                [](effort e) { return affordable(e, most_path_steps); }},
               out))
    return;
  const double between = static_cast<double>(plan.steps) * f.dt;
  auto changes = pullback_changes(c, f, plan, log, log.open({"pullback"}, blocks_of(plan.paths)));
  const auto open = [&](const squared_errors& of) { return resolved_levels(of) < static_cast<int>(least_levels); };
  const double one_path = work() / plan.paths;
  const int affordable_paths = std::min(most_paths, static_cast<int>(most / one_path));
  if (std::ranges::any_of(changes, open) && affordable_paths > plan.paths) {
    plan.paths = affordable_paths;
    changes = pullback_changes(c, f, plan, log, log.open({"pullback, more paths"}, blocks_of(plan.paths)));
  }
  for (std::size_t s = 0; s < f.schemes.size(); ++s) {
    recorder record("attractor", f.schemes[s].info.name, out);
    report_scheme(changes[s], between, f.gap, c.seed, record);
  }
}

}  // namespace polhode
