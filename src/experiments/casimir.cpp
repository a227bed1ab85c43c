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
#include "experiments/noise_verdict.hpp"
#include "experiments/poisson_map.hpp"
#include "experiments/rounding_floor.hpp"
#include "experiments/sequential.hpp"
#include "statistics/order_fit.hpp"

namespace polhode {
namespace {

constexpr double rounding_bound = 1e-12;  // relative drift allowed after a million steps
constexpr double judged_steps = 1e6;
constexpr int chunk_steps = 1000;

int most_paths(const context& c) { return by_effort(c.effort, 640, 2048, 8192); }

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

void run_exact(const context& c, noise_log& log, report::results& out) {
  const auto& s = c.subject;
  const int chunks = by_effort(c.effort, 1000, 2500, 10'000);
  const double dt = s.scene.horizon / static_cast<double>(s.scene.steps.back());
  std::vector<long_run> runs;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact) runs.push_back({&scheme, scheme.make(dt), replicated(s.scene.momentum), {}, {}, {}});
  if (runs.empty()) return;
  increment_buffer noise(*s.model, chunk_steps, any_needs_areas(s.schemes), {c.generator, noise_quality::fast});
  double next = 1;
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const auto first = static_cast<std::uint64_t>(chunk) * chunk_steps;
    const auto view =
        s.model->active_channels() > 0 ? noise.fill(c.seed, 0, first, chunk_steps, dt) : silence(chunk_steps, dt);
    if (!view.silent()) log.add(0, view);
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

/// One scheme of those that drift, at every level.
struct drift_sample {
  const scheme_entry* scheme;
  std::vector<std::unique_ptr<kernel>> kernels;
  squared_errors squares;
  std::optional<order_fit> fit;
};

/// Squared drifts of one block of paths of the open schemes.
void run_block(const context& c, const level_grid& grid, std::span<const int> open, int block,
               std::vector<drift_sample>& samples, noise_log& log) {
  const auto& m = *c.subject.model;
  const bool areas =
      std::ranges::any_of(open, [&](int k) { return samples[static_cast<std::size_t>(k)].scheme->needs_areas; });
  increment_buffer noise(m, grid.steps.back(), areas, {c.generator, noise_quality::precise});
  const int first_path = block * block_lanes;
  for (std::size_t l = 0; l < grid.steps.size(); ++l) {
    const int n = grid.steps[l];
    const double dt = grid.horizon / n;
    const auto view =
        m.active_channels() > 0 ? noise.fill(c.seed, static_cast<std::uint64_t>(first_path), 0, n, dt) : silence(n, dt);
    if (l + 1 == grid.steps.size() && !view.silent()) log.add(block, view, 1);  // the others have the same normals
    for (const int k : open) {
      auto& sample = samples[static_cast<std::size_t>(k)];
      auto states = replicated(c.subject.scene.momentum);
      sample.kernels[l]->advance(states, view);
      const auto d = drifts(m, states, c.subject.scene.momentum);
      for (int lane = 0; lane < block_lanes; ++lane)
        sample.squares.at(first_path + lane, static_cast<int>(l)) = std::pow(d[static_cast<std::size_t>(lane)], 2);
    }
  }
}

void report_drift(const drift_sample& sample, std::span<const double> dt, bool noisy, report::results& out) {
  const auto& info = sample.scheme->info;
  const series s{
      "casimir", std::string(info.name), "drift", "casimir", "relative", noisy ? "sampled" : "deterministic"};
  std::vector<report::measurement> points;
  for (int l = 0; l < sample.squares.levels; ++l) {
    const auto m = level_mean(sample.squares, l);
    points.push_back(measured(s, dt[static_cast<std::size_t>(l)], std::sqrt(m.mean),
                              std::sqrt(std::max(0.0, m.mean - 1.96 * m.error)), std::sqrt(m.mean + 1.96 * m.error)));
  }
  record_fit(out, s, sample.fit, std::move(points));
  out.verdicts.push_back(judge_order({s.experiment, s.scheme, "order of the Casimir drift"},
                                     noisy ? info.casimir.noisy_order : info.casimir.deterministic_order, sample.fit,
                                     true));
}

void run_drifting(const context& c, noise_log& log, report::results& out) {
  constexpr double floor = 1e-13;
  const bool noisy = c.subject.model->noise() != noise_class::none;
  const auto grid = asymptotic_levels(c.subject, 256);
  const auto dt = grid.dt();
  const sampling_plan plan{noisy ? 320 : 1, noisy ? most_paths(c) : 1};
  const int paths = blocks_of(plan.most) * block_lanes, levels = static_cast<int>(dt.size());
  std::vector<drift_sample> samples;
  for (const auto& scheme : c.subject.schemes) {
    if (scheme.info.casimir.exact) continue;
    samples.push_back(
        {&scheme, {}, {paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))}, {}});
    for (const double h : dt) samples.back().kernels.push_back(scheme.make(h));
  }
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(samples.size()),
      [&](int block, std::span<const int> open) { run_block(c, grid, open, block, samples, log); },
      [&](int scheme, int so_far) {
        auto& [_, kernels, squares, fit] = samples[static_cast<std::size_t>(scheme)];
        squares.paths = so_far;
        std::vector<double> rms;
        for (int l = 0; l < levels; ++l) rms.push_back(std::sqrt(level_mean(squares, l).mean));
        fit = noisy ? fit_order(dt, squares, floor, c.seed) : fit_order(dt, rms, floor);
        return !fit || half_width(*fit) <= tight_order;  // without a fit more paths would not help
      });
  for (std::size_t k = 0; k < samples.size(); ++k) {
    report_drift(samples[k], dt, noisy, out);
    if (noisy) note_sample_size(out, "casimir", samples[k].scheme->info.name, sizes[k]);
  }
}

void run(const context& c, report::results& out) {
  noise_log log(*c.subject.model, blocks_of(most_paths(c)), {{"", 0}, {"precise", 0}});
  run_exact(c, log, out);
  run_drifting(c, log, out);
  log.report("casimir", out);
  for (const auto& scheme : c.subject.schemes) {
    report_floor({"casimir", std::string(scheme.info.name), "state at the rounding floor"},
                 rounding_floor_of(c, c.subject, scheme).state, out);
    report_poisson_map(c, scheme.info.name, out);
  }
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
        "they are drawn from a weak surrogate (independent normals of variance dt^2/4).",
        "Rounding floor: high differences of the state over steps that differ a little are rounding alone.",
        "Poisson map: whether the Jacobian J of a step without noise and dissipation, by dual numbers, keeps the "
        "bracket, J B(mu) J^T = B(step(mu)). Of schemes that do not claim it, the order of what is missing, which is "
        "their deterministic order and one more, or better.",
        "Normals: fast ones (right to 1e-6) in the long runs, precise ones for the drift."}},
      3,
      [](const subject&) -> std::optional<std::string> { return std::nullopt; },
      run};
}

}  // namespace polhode
