// Does a scheme stay on its coadjoint orbit?
//
// Schemes that claim to keep the Casimirs run for millions of steps: only rounding may show, and its growth law is
// reported. For the others the drift over a fixed time is measured against dt, and its order is held against the claim.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/paths.hpp"
#include "experiments/experiment.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/progress_counter.hpp"
#include "statistics/order_fit.hpp"

namespace polhode {
namespace {

constexpr double rounding_bound = 1e-12;  // relative drift allowed after a million steps
constexpr double judged_steps = 1e6;
constexpr int chunk_steps = 1000;

/// The largest relative change among the Casimirs, per lane.
std::vector<double> drifts(const model& m, std::span<const double> states, std::span<const double> start) {
  const auto reference = m.casimirs(start);
  std::vector<double> out;
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto now = m.casimirs(lane_of(states, lane, m.dimension()));
    double worst = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double change = std::fabs(now[i] - reference[i]) / std::max(std::fabs(reference[i]), 1e-300);
      worst = std::isfinite(change) ? std::max(worst, change) : std::numeric_limits<double>::infinity();
    }
    out.push_back(worst);
  }
  return out;
}

/// One scheme on one block of paths for a long time.
struct long_run {
  const scheme_entry* scheme;
  std::unique_ptr<kernel> stepper;
  std::vector<double> states;
  std::vector<double> steps, rms, largest;  ///< the drift at each time of measurement

  void measure(const model& m, std::span<const double> start, double n) {
    const auto d = drifts(m, states, start);
    double square = 0;
    for (const double x : d) square += x * x / block_lanes;
    steps.push_back(n);
    rms.push_back(std::sqrt(square));
    largest.push_back(std::ranges::max(d));
  }
};

void report_long_run(const long_run& run, double dt, report::results& out) {
  const series s{"casimir", std::string(run.scheme->info.name), "drift_over_steps", "casimir", "relative", "sampled"};
  std::vector<report::measurement> points;
  double judged = 0;
  for (std::size_t i = 0; i < run.steps.size(); ++i) {
    auto m = measured(s, dt, run.rms[i], std::nullopt, run.largest[i]);
    m.steps = run.steps[i];
    points.push_back(m);
    judged = std::max(judged, run.largest[i] * std::min(1.0, judged_steps / run.steps[i]));
  }
  const auto growth = fit_power_law(run.steps, run.rms);
  record_fit(out, s, growth, std::move(points));
  const claim c{s.experiment, s.scheme, "Casimirs kept to rounding"};
  if (!std::isfinite(judged)) {
    // An implicit step that found no solution says nothing of the orbit; an explicit path that is gone has left it.
    auto v = judge_distance(c, {judged, judged, judged}, rounding_bound,
                            run.scheme->info.implicit ? "a path was lost: a step's equation was not solved"
                                                      : "a path left the orbit for infinity");
    if (!run.scheme->info.implicit) v.kind = report::verdict_kind::refuted;
    out.verdicts.push_back(v);
    return;
  }
  out.verdicts.push_back(
      judge_distance(c, {judged, judged, judged}, rounding_bound,
                     fmt::format("largest relative drift {:.1e} per 10^6 steps, over {:.0e} steps{}", judged,
                                 run.steps.back(), growth ? fmt::format("; grows like n^{:.2f}", growth->order) : "")));
}

void run_exact(const context& c, report::results& out) {
  const auto& s = c.subject;
  const int chunks = by_effort(c.effort, 1000, 10'000, 10'000);
  const double dt = s.scene.horizon / static_cast<double>(s.scene.steps.back());
  std::vector<long_run> runs;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact) runs.push_back({&scheme, scheme.make(dt), replicated(s.scene.momentum), {}, {}, {}});
  if (runs.empty()) return;
  increment_buffer noise(*s.model, chunk_steps, any_needs_areas(s.schemes));
  double next = 1;
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const auto first = static_cast<std::uint64_t>(chunk) * chunk_steps;
    const auto view =
        s.model->active_channels() > 0 ? noise.fill(c.seed, 0, first, chunk_steps, dt) : silence(chunk_steps, dt);
    parallel_for(c.threads, static_cast<int>(runs.size()), [&](int k) {
      auto& r = runs[static_cast<std::size_t>(k)];
      r.stepper->advance(r.states, view);
    });
    if (chunk + 1 >= next) {  // at 1, 2, 4, … chunks
      for (auto& r : runs) r.measure(*s.model, s.scene.momentum, static_cast<double>(chunk + 1) * chunk_steps);
      next *= 2;
    }
    if (chunk % 50 == 0) c.progress(0.9 * chunk / chunks);
  }
  for (auto& r : runs) {
    if (r.steps.back() < static_cast<double>(chunks) * chunk_steps)
      r.measure(*s.model, s.scene.momentum, static_cast<double>(chunks) * chunk_steps);
    report_long_run(r, dt, out);
  }
}

/// Squared drift of each path at each level.
squared_errors drift_by_level(const context& c, const scheme_entry& scheme, const level_grid& grid, int blocks) {
  const auto& m = *c.subject.model;
  const int levels = static_cast<int>(grid.steps.size()), paths = blocks * block_lanes;
  squared_errors out{paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))};
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const double dt : grid.dt()) kernels.push_back(scheme.make(dt));
  parallel_for(c.threads, blocks, [&](int block) {
    increment_buffer noise(m, grid.steps.back(), scheme.needs_areas);
    for (int l = 0; l < levels; ++l) {
      const int n = grid.steps[static_cast<std::size_t>(l)];
      auto states = replicated(c.subject.scene.momentum);
      const double dt = grid.horizon / n;
      kernels[static_cast<std::size_t>(l)]->advance(
          states, m.active_channels() > 0
                      ? noise.fill(c.seed, static_cast<std::uint64_t>(block * block_lanes), 0, n, dt)
                      : silence(n, dt));
      const auto d = drifts(m, states, c.subject.scene.momentum);
      for (int lane = 0; lane < block_lanes; ++lane)
        out.at(block * block_lanes + lane, l) = std::pow(d[static_cast<std::size_t>(lane)], 2);
    }
  });
  return out;
}

void run_drifting(const context& c, report::results& out) {
  const bool noisy = c.subject.model->noise() != noise_class::none;
  const auto grid = asymptotic_levels(c.subject, 256);
  const auto dt = grid.dt();
  for (const auto& scheme : c.subject.schemes) {
    if (scheme.info.casimir.exact) continue;
    const auto squares = drift_by_level(c, scheme, grid, noisy ? by_effort(c.effort, 40, 128, 512) : 1);
    const series s{"casimir",  std::string(scheme.info.name),      "drift", "casimir",
                   "relative", noisy ? "sampled" : "deterministic"};
    std::vector<report::measurement> points;
    std::vector<double> rms;
    for (int l = 0; l < squares.levels; ++l) {
      const auto m = level_mean(squares, l);
      rms.push_back(std::sqrt(m.mean));
      points.push_back(measured(s, dt[static_cast<std::size_t>(l)], rms.back(),
                                std::sqrt(std::max(0.0, m.mean - 1.96 * m.error)), std::sqrt(m.mean + 1.96 * m.error)));
    }
    constexpr double floor = 1e-13;
    const auto fit = noisy ? fit_order(dt, squares, floor, c.seed) : fit_order(dt, rms, floor);
    record_fit(out, s, fit, std::move(points));
    out.verdicts.push_back(
        judge_order({s.experiment, s.scheme, "order of the Casimir drift"},
                    noisy ? scheme.info.casimir.noisy_order : scheme.info.casimir.deterministic_order, fit, true));
  }
}

void run(const context& c, report::results& out) {
  run_exact(c, out);
  run_drifting(c, out);
}

}  // namespace

experiment casimir_experiment() {
  return {
      {"casimir",
       "Does the scheme stay on the coadjoint orbit on which it started?",
       {fmt::format("Schemes that claim it run for a million steps and more on {} paths at the scene's finest dt; a "
                    "relative drift of {:g} per million steps is the bound. Plotted: root mean square over the paths; "
                    "bars reach to the largest.",
                    block_lanes, rounding_bound),
        "For the others: root-mean-square relative drift over the horizon against dt. Where a long run needs Levy "
        "areas "
        "they are drawn from a weak surrogate (independent normals of variance dt^2/4)."}},
      3,
      [](const subject&) -> std::optional<std::string> { return std::nullopt; },
      run};
}

}  // namespace polhode
