// Does the snapshot at time 0 stop changing when the same noise has acted for longer?
//
// Bodies start uniformly at -T_1, -T_2, … and see the noise of one path up to time 0; the step before time 0 has the
// same noise for every T. Two sets of bodies that know nothing of each other give c, c' at each T, and the product of
// their changes, (c_T - c_T+).(c'_T - c'_T+), has the square of the change of the random measure itself as its mean:
// that the sets are finite adds scatter and no bias. A path has several times 0, a span apart: bodies that are of age T
// at one of them are of the next T at the next, so that a look costs seven spans in place of 28. Looks at one path are
// not independent, and intervals are over paths.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/attractor/harmonic_means.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "statistics/orders/level_choice.hpp"

namespace polhode {
namespace {

constexpr int degree = 4;
constexpr int spans = 7;                           // to the longest T, of which six changes are left
constexpr double span_time = 2.5;                  // in the time in which the area of a set shrinks by e
constexpr double clear_of_zero = 3;                // standard errors that a level must have above zero to be fitted
constexpr double most_path_steps = 1e8;            // of one scheme at quick effort
constexpr int least_paths = 24, most_paths = 288;  // the most where too few levels are clear of zero for a fit
constexpr int least_looks = 4, most_looks = 7;
constexpr const char* pullback_claim = "pullback converges";

struct pullback_plan {
  std::int64_t steps;  ///< between two starts
  int paths, blocks;   ///< blocks of bodies a set
  int looks;           ///< at a path, a span apart

  std::int64_t all_steps() const { return (spans + looks - 1) * steps; }
  /// Of one set and scheme.
  std::int64_t spans_run() const { return looks * spans + spans * (spans - 1) / 2; }
};

/// Coefficients of both sets, by look and by the spans since their start.
using snapshots = std::vector<std::array<std::array<Eigen::VectorXd, 2>, spans>>;

/// Bodies that start at one time grow old together: looked at, they are of one age after the other.
void follow(const context& c, const attractor_frame& f, const pullback_plan& plan, const kernel& k,
            const shared_steps& noise, int start, std::size_t set, snapshots& out) {
  harmonic_means means(degree);
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

/// By scheme and noise path; all schemes see the same noise.
std::vector<squared_errors> changes_of(const context& c, const attractor_frame& f, const pullback_plan& plan,
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

/// The levels from the first on that are clear of zero.
int clear_levels(const squared_errors& changes) {
  int n = 0;
  for (; n < changes.levels; ++n) {
    const auto m = level_mean(changes, n);
    if (!(m.mean > clear_of_zero * m.error)) break;
  }
  return n;
}

/// Distances fall like exp(-rate T): the mean squares over 2^-T in spans have the order 2 rate span / log 2.
std::optional<interval_estimate> rate_of(const squared_errors& changes, double span, std::uint64_t seed) {
  const int levels = clear_levels(changes);
  squared_errors clear{changes.paths, levels, {}};
  for (int path = 0; path < changes.paths; ++path)
    for (int i = 0; i < levels; ++i) clear.values.push_back(changes.at(path, i));
  std::vector<double> abscissa;
  for (int i = 0; i < levels; ++i) abscissa.push_back(std::exp2(-1.0 - i));
  const auto fit = fit_power_law_of_means(abscissa, clear, seed);
  if (!fit) return std::nullopt;
  const double unit = std::numbers::ln2 / (2 * span);
  return interval_estimate{unit * fit->order, unit * fit->low, unit * fit->high};
}

void report_changes(const std::string& name, const squared_errors& changes, double span, report::results& out) {
  const series s{"attractor", name, "change of the snapshot", "density", "of the uniform density", "sampled"};
  const int clear = clear_levels(changes);
  for (int i = 0; i < changes.levels; ++i) {
    const auto m = level_mean(changes, i);
    const auto root = [](double x) { return std::sqrt(std::max(0.0, x)); };
    auto point = measured(s, {}, root(m.mean), root(m.mean - 1.96 * m.error), root(m.mean + 1.96 * m.error));
    point.steps = (i + 1) * span;
    point.abscissa = "time T before the snapshot";
    point.fitted = i < clear;
    if (i >= clear) point.status = "not clear of zero";
    out.measurements.push_back(point);
  }
}

void report_rate(const std::string& name, const std::optional<interval_estimate>& rate, double gap,
                 report::results& out) {
  report::verdict v{"attractor", name, pullback_claim, {}, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (!rate) {
    v.reason = "the snapshot changes too little, or too irregularly, for a rate";
  } else {
    out.measurements.push_back(measured({"attractor", name, "pullback rate", "", "per time", "sampled"}, {},
                                        rate->value, rate->low, rate->high));
    v.estimate = rate->value;
    v.low = rate->low;
    v.high = rate->high;
    v.kind = rate->low > 0    ? report::verdict_kind::holds
             : rate->high < 0 ? report::verdict_kind::refuted
                              : report::verdict_kind::inconclusive;
    v.reason = fmt::format(
        "the change falls like exp(-r T), r = {:.4f} in [{:.4f}, {:.4f}], above 0; one body forgets "
        "its start at the rate {:.4f}",
        rate->value, rate->low, rate->high, gap);
  }
  out.verdicts.push_back(v);
}

}  // namespace

void report_pullback(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const double span = -span_time / f.exponents.sum;
  pullback_plan plan{f.steps_in(span, f.dt), by_effort(c.effort, 24, 144, 144), by_effort(c.effort, 1, 2, 2),
                     most_looks};
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
  auto changes = changes_of(c, f, plan, log, log.open({"pullback"}, blocks_of(plan.paths)));
  const auto open = [&](const squared_errors& of) { return clear_levels(of) < static_cast<int>(least_levels); };
  const double one_path = work() / plan.paths;
  const int affordable_paths = std::min(most_paths, static_cast<int>(most / one_path));
  if (std::ranges::any_of(changes, open) && affordable_paths > plan.paths) {
    plan.paths = affordable_paths;
    changes = changes_of(c, f, plan, log, log.open({"pullback, more paths"}, blocks_of(plan.paths)));
  }
  for (std::size_t s = 0; s < f.schemes.size(); ++s) {
    const std::string name(f.schemes[s].info.name);
    report_changes(name, changes[s], between, out);
    report_rate(name, rate_of(changes[s], between, c.seed), f.gap, out);
  }
}

}  // namespace polhode
