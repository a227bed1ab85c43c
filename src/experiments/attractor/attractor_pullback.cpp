// SPDX-License-Identifier: Apache-2.0
// Does the snapshot at time 0 stop changing when the same noise has acted for longer?
//
// Looks at one path are not independent, and intervals are over paths.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/attractor/harmonic_moments.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "statistics/distributions.hpp"
#include "statistics/orders/level_choice.hpp"
#include "statistics/orders/order_fit.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

// How much the snapshot at time 0 changes when the same noise has acted for longer.
//
// Bodies start uniformly at -T_1, -T_2, … and see the noise of one path up to time 0; the step before time 0 has the
// same noise for every T. Two sets of bodies that know nothing of each other give c, c' at each T, and the product of
// their changes, (c_T - c_T+).(c'_T - c'_T+), has the square of the change of the random measure itself as its mean:
// that the sets are finite adds scatter and no bias. A path has several times 0, a span apart: bodies that are of age T
// at one of them are of the next T at the next, so that a look costs seven spans in place of 28.

constexpr int pullback_spans = 7;  ///< to the longest T, of which six changes are left

struct pullback_plan {
  std::int64_t steps;  ///< between two starts
  int paths, blocks;   ///< blocks of bodies a set
  int looks;           ///< at a path, a span apart

  std::int64_t all_steps() const { return (pullback_spans + looks - 1) * steps; }
  /// Of one set and scheme.
  std::int64_t spans_run() const { return looks * pullback_spans + pullback_spans * (pullback_spans - 1) / 2; }
};

constexpr int change_degree = 4, spans = pullback_spans;

/// Coefficients of both sets, by look and by the spans since their start.
using snapshots = std::vector<std::array<std::array<Eigen::VectorXd, 2>, spans>>;

/// Bodies that start at one time grow old together: looked at, they are of one age after the other.
void follow(const context& c, const attractor_frame& f, const pullback_plan& plan, const kernel& k,
            const shared_steps& noise, int start, std::size_t set, snapshots& out) {
  harmonic_moments means(change_degree);
  const auto blocks = static_cast<std::size_t>(plan.blocks);
  std::vector<std::vector<double>> states(blocks, std::vector<double>(3 * block_lanes));
  for (std::size_t b = 0; b < blocks; ++b)
    start_uniformly(c.seed, (set * blocks + b) * block_lanes, f.problem.radius, states[b]);
  for (int age = 0; age < spans;) {
    const int next = std::max(age + 1, spans - start), look = start + next - spans;  // to the first look at once
    if (look >= plan.looks) return;
    for (auto& block : states) {
      k.advance(block, noise, (start + age) * plan.steps, (next - age) * plan.steps);
      means.add(block);
    }
    age = next;
    out[static_cast<std::size_t>(look)][static_cast<std::size_t>(age - 1)][set] = means.take();
  }
}

snapshots pulled_back(const context& c, const attractor_frame& f, const pullback_plan& plan, const kernel& k,
                      const shared_steps& noise) {
  snapshots out(static_cast<std::size_t>(plan.looks));
  for (int start = 0; start < spans + plan.looks - 1; ++start)
    for (std::size_t set = 0; set < 2; ++set) follow(c, f, plan, k, noise, start, set, out);
  return out;
}

/// Of one path of one scheme: squares of the change from T to the next T, mean over the looks.
void add_changes(const snapshots& at, int path, squared_errors& out) {
  for (const auto& look : at)
    for (int i = 0; i + 1 < spans; ++i) {
      const auto &here = look[static_cast<std::size_t>(i)], &next = look[static_cast<std::size_t>(i + 1)];
      out.at(path, i) += (here[0] - next[0]).dot(here[1] - next[1]) / static_cast<double>(at.size());
    }
}

/// Squares of the change from T to the next T, mean over the looks at a path: by scheme and noise path. All schemes see
/// the same noise, and the log hears it.
std::vector<squared_errors> pullback_changes(const context& c, const attractor_frame& f, const pullback_plan& plan,
                                             noise_log& log, std::size_t part) {
  const squared_errors nothing{plan.paths, spans - 1,
                               std::vector<double>(static_cast<std::size_t>(plan.paths * (spans - 1)))};
  std::vector<squared_errors> out(f.schemes.size(), nothing);
  std::vector<std::unique_ptr<kernel>> steppers;
  for (const auto& scheme : f.schemes) steppers.push_back(scheme.make(f.dt));
  progress_counter done(plan.paths, c.progress);
  for (int first = 0; first < plan.paths; first += block_lanes) {
    const auto drawn =
        shared_increments::of_block(*c.subject.model, c.seed, plan.all_steps(), f.dt, any_needs_areas(f.schemes),
                                    fast_noise(c), static_cast<std::uint64_t>(first));
    const int paths = std::min(block_lanes, plan.paths - first);
    const auto view = [&](int i) {
      return drawn[static_cast<std::size_t>(i)].view(0, static_cast<int>(plan.all_steps()));
    };
    for (int i = 0; i < paths; ++i) log.add_path(first + i, view(i), f.dt, part);
    parallel_for(c.threads, paths, [&](int i) {
      for (std::size_t s = 0; s < steppers.size(); ++s)
        add_changes(pulled_back(c, f, plan, *steppers[s], steppers[s]->share(view(i))), first + i, out[s]);
      done.add();
    });
  }
  return out;
}

constexpr double span_time = 2.5;            // in the time in which the area of a set shrinks by e
constexpr double least_standard_errors = 3;  // that a level must have above zero to be fitted
constexpr double most_pullback_steps = 1e8;  // of one scheme at quick effort
constexpr int least_pullback_paths = 24,
              most_pullback_paths = 288;  // the most where too few levels are resolved for a fit
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

report::verdict judge_convergence(const std::optional<interval_estimate>& rate, double gap) {
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
  record.verdict(pullback_claim, judge_convergence(rate, gap), evidence);
}

}  // namespace

void report_pullback(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double span = -span_time / f.exponents.sum;
  pullback_plan plan{f.steps_in(span, f.dt), by_effort(c.effort, 24, 144, 144), by_effort(c.effort, 1, 2, 2),
                     by_effort(c.effort, least_looks, most_looks, most_looks)};
  const double most = affordable(c.effort, most_pullback_steps);
  const auto work = [&] {
    return 2.0 * static_cast<double>(plan.spans_run() * plan.steps) * plan.paths * plan.blocks * block_lanes;
  };
  while (work() > most && plan.looks > least_looks) --plan.looks;
  while (work() > most && plan.paths > least_pullback_paths) plan.paths /= 2;
  if (!affords(c, f.schemes,
               {"attractor", pullback_claim, "forgetting the start", "path-steps a scheme", work(),
                [](effort e) { return affordable(e, most_pullback_steps); }},
               out))
    return;
  const double between = static_cast<double>(plan.steps) * f.dt;
  auto changes = pullback_changes(c, f, plan, log, log.open({"pullback"}, blocks_of(plan.paths)));
  const auto open = [&](const squared_errors& of) { return resolved_levels(of) < static_cast<int>(least_levels); };
  const double one_path = work() / plan.paths;
  const int affordable_paths = std::min(most_pullback_paths, static_cast<int>(most / one_path));
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
