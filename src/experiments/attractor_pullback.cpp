// Does the snapshot at time 0 stop changing when the same noise has acted for longer?
//
// Bodies start uniformly at -T_1, -T_2, … and see the noise of one path up to time 0; the step before time 0 has the
// same noise for every T. Two sets of bodies that know nothing of each other give c, c' at each T, and the product of
// their changes, (c_T - c_T+).(c'_T - c'_T+), has the square of the change of the random measure itself as its mean:
// that the sets are finite adds scatter and no bias.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ensemble/paths.hpp"
#include "ensemble/shared_increments.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor.hpp"
#include "experiments/harmonic_means.hpp"
#include "experiments/progress_counter.hpp"
#include "experiments/sequential.hpp"
#include "experiments/undecided.hpp"

namespace polhode {
namespace {

constexpr int degree = 4;
constexpr int spans = 7;                   // to the longest T, of which six changes are left
constexpr double span_time = 2.5;          // in the time in which the area of a set shrinks by e
constexpr double clear_of_zero = 3;        // standard errors that a level must have above zero to be fitted
constexpr double most_path_steps = 1.5e8;  // of one scheme at quick effort
constexpr int least_paths = 32;
constexpr const char* pullback_claim = "pullback converges";

struct pullback_plan {
  std::int64_t steps;  ///< between two starts
  int paths, blocks;   ///< blocks of bodies a set
};

/// The coefficients of both sets at time 0, by the number of spans before it.
using snapshots = std::vector<std::array<Eigen::VectorXd, 2>>;

snapshots pulled_back(const context& c, const attractor_frame& f, const pullback_plan& plan, const kernel& k,
                      const shared_steps& noise) {
  harmonic_means means(degree);
  std::vector<double> states(3 * block_lanes);
  snapshots out;
  for (int span = 1; span <= spans; ++span) {
    const std::int64_t steps = span * plan.steps, first = spans * plan.steps - steps;
    auto& at = out.emplace_back();
    for (std::size_t set = 0; set < 2; ++set) {
      for (int block = 0; block < plan.blocks; ++block) {
        const auto bodies = (static_cast<int>(set) * plan.blocks + block) * block_lanes;
        start_uniformly(c.seed, static_cast<std::uint64_t>(bodies), f.problem.radius, states);
        k.advance(states, noise, first, steps);
        means.add(states);
      }
      at[set] = means.take();
    }
  }
  return out;
}

/// Squares of the change from T to the next T, by noise path; `hear` is told on any thread.
squared_errors changes_of(const context& c, const attractor_frame& f, const pullback_plan& plan,
                          const scheme_entry& scheme, const path_listener& hear) {
  const auto stepper = scheme.make(f.dt);
  const std::int64_t all = spans * plan.steps;
  squared_errors out{plan.paths, spans - 1, std::vector<double>(static_cast<std::size_t>(plan.paths * (spans - 1)))};
  parallel_for(c.threads, plan.paths, [&](int path) {
    const shared_increments drawn(*c.subject.model, c.seed, all, f.dt, scheme.needs_areas, 1, fast_noise(c),
                                  static_cast<std::uint64_t>(path));
    const auto view = drawn.view(0, static_cast<int>(all));
    if (hear) hear(path, view);
    const auto at = pulled_back(c, f, plan, *stepper, stepper->share(view));
    for (int i = 0; i + 1 < spans; ++i) {
      const auto &here = at[static_cast<std::size_t>(i)], &next = at[static_cast<std::size_t>(i + 1)];
      out.at(path, i) = (here[0] - next[0]).dot(here[1] - next[1]);
    }
  });
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
  pullback_plan plan{f.steps_in(span, f.dt), by_effort(c.effort, 64, 384, 384), by_effort(c.effort, 2, 4, 4)};
  const double most = affordable(c.effort, most_path_steps);
  const auto work = [&] {
    return 1.0 * spans * (spans + 1) * static_cast<double>(plan.steps) * plan.paths * plan.blocks * block_lanes;
  };
  while (work() > most && plan.paths > least_paths) plan.paths /= 2;
  if (!affords(c, f.schemes,
               {"attractor", pullback_claim, "forgetting the start", "path-steps a scheme", work(),
                [](effort e) { return affordable(e, most_path_steps); }},
               out))
    return;
  progress_counter done(static_cast<int>(f.schemes.size()), c.progress);
  const auto part = log.open({"pullback"}, blocks_of(plan.paths));
  std::vector<std::optional<noise_audit>> heard(static_cast<std::size_t>(plan.paths));
  const path_listener hear = [&](int path, const increment_view& v) {
    heard[static_cast<std::size_t>(path)] = log.alone(path, v, part);
  };
  for (const auto& scheme : f.schemes) {
    const std::string name(scheme.info.name);
    const auto changes = changes_of(c, f, plan, scheme, &scheme == &heard_among(f.schemes) ? hear : path_listener{});
    const double between = static_cast<double>(plan.steps) * f.dt;
    report_changes(name, changes, between, out);
    report_rate(name, rate_of(changes, between, c.seed), f.gap, out);
    done.add();
  }
  for (int path = 0; path < plan.paths; ++path)
    if (const auto& one = heard[static_cast<std::size_t>(path)]) log.join(path, *one, part);
}

}  // namespace polhode
