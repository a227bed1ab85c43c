// SPDX-License-Identifier: Apache-2.0
#include "experiments/casimir/casimir_long_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/casimir/casimir_drift.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

constexpr double judged_steps = 1e6;
constexpr int chunk_steps = 1000;
constexpr int few_components = 3;

/// Where a step costs several of a rigid body's.
bool dear_steps(const subject& s) {
  return s.model->dimension() > few_components || s.model->noise() == noise_class::state_dependent ||
         (s.sphere() && s.sphere()->has_field());
}

/// dear: by what is known of the schemes.
int chunks_of(const context& c, bool dear) {
  if (dear) return 100;
  if (c.effort == effort::quick && dear_steps(c.subject)) return std::max(40, 600 / c.subject.model->dimension());
  return by_effort(c.effort, 1000, 2500, 10'000);
}

/// One scheme on one block of paths for a long time.
struct long_run {
  const scheme_entry* scheme;
  std::unique_ptr<kernel> stepper;
  std::vector<double> states;
  std::vector<double> steps, rms, largest;  ///< the drift at each time of measurement

  void measure(const model& m, std::span<const double> start, double n) {
    const auto d = casimir_drifts(m, states, start);
    double square = 0;
    for (const double x : d) square += x * x / block_lanes;
    steps.push_back(n);
    rms.push_back(std::sqrt(square));
    largest.push_back(std::ranges::max(d));
  }
};

/// judged: the largest relative drift per so many steps as are judged.
report::verdict judge_long_run(const long_run& run, double judged, const std::optional<order_fit>& growth) {
  if (!std::isfinite(judged)) {
    // An implicit step that found no solution says nothing of the orbit; an explicit path that is gone has left it.
    auto v = judge_distance({judged, judged, judged}, rounding_bound,
                            run.scheme->info.implicit ? "a path was lost: a step's equation was not solved"
                                                      : "a path left the orbit for infinity");
    if (!run.scheme->info.implicit) v.kind = report::verdict_kind::refuted;
    return v;
  }
  return judge_distance(
      {judged, judged, judged}, rounding_bound,
      fmt::format("largest relative drift {:.1e} per 10^6 steps, over {:.0e} steps{}", judged, run.steps.back(),
                  growth ? fmt::format("; grows like n^{:.2f}", growth->order) : ""));
}

/// The largest per so many steps as are judged. A shorter run is taken on as it grows: no slower than a random walk,
/// and linearly where that is not known.
double judged_drift(const long_run& run, const std::optional<order_fit>& growth) {
  double judged = 0;
  for (std::size_t i = 0; i < run.steps.size(); ++i)
    judged = std::max(judged, run.largest[i] * std::min(1.0, judged_steps / run.steps[i]));
  if (run.steps.back() < judged_steps)
    judged *= std::pow(judged_steps / run.steps.back(), growth ? std::clamp(growth->order, 0.5, 1.0) : 1.0);
  return judged;
}

/// A guess that is beyond the bound, and not far, refutes nothing: the run has to go on.
bool too_near_to_guess(const long_run& run) {
  if (run.steps.back() >= judged_steps) return false;
  const double judged = judged_drift(run, fit_power_law(run.steps, run.rms));
  return judged > rounding_bound && judged < 10 * rounding_bound;
}

void report_long_run(const long_run& run, double dt, recorder record) {
  curve drift{{"drift_over_steps", "casimir", "relative", "sampled"}, report::step_count, "1"};
  drift.at = {at_dt(dt)};
  for (std::size_t i = 0; i < run.steps.size(); ++i) drift.add(run.steps[i], run.rms[i], std::nullopt, run.largest[i]);
  const auto growth = fit_power_law(run.steps, run.rms);
  const auto written = record.series(drift, growth);
  record.verdict("Casimirs kept to rounding", judge_long_run(run, judged_drift(run, growth), growth), {written});
}

}  // namespace

void report_long_runs(const context& c, bool dear, noise_log& log, report::results& out) {
  const auto& s = c.subject;
  const int chunks = chunks_of(c, dear);
  const double dt = finest_step(s);
  std::vector<long_run> runs;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact) runs.push_back({&scheme, scheme.make(dt), replicated(s.scene.momentum), {}, {}, {}});
  if (runs.empty()) return;
  increment_buffer noise(*s.model, chunk_steps, any_needs_areas(s.schemes), {c.generator, noise_quality::fast});
  const auto chunk_of_noise = [&](int chunk) {
    const auto first = static_cast<std::uint64_t>(chunk) * chunk_steps;
    return !s.model->layout().silent() ? noise.fill(c.seed, 0, first, chunk_steps, dt) : silence(chunk_steps);
  };
  const auto measure = [&](long_run& r, int done) {
    r.measure(*s.model, s.scene.momentum, static_cast<double>(done) * chunk_steps);
  };
  double next = 1;
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const auto view = chunk_of_noise(chunk);
    if (!view.silent()) log.add(0, view, dt);
    parallel_for(c.threads, static_cast<int>(runs.size()), [&](int k) {
      auto& r = runs[static_cast<std::size_t>(k)];
      r.stepper->advance(r.states, view);
    });
    if (chunk + 1 >= next) {  // at 1, 2, 4, … chunks
      for (auto& r : runs) measure(r, chunk + 1);
      next *= 2;
    }
    if (chunk % 50 == 0) c.progress(0.9 * chunk / chunks);
  }
  for (auto& r : runs)
    if (r.steps.back() < static_cast<double>(chunks) * chunk_steps) measure(r, chunks);
  std::vector<long_run*> open;
  for (auto& r : runs)
    if (too_near_to_guess(r)) open.push_back(&r);
  const int enough = static_cast<int>(judged_steps) / chunk_steps;
  for (int chunk = chunks; chunk < enough && !open.empty(); ++chunk) {
    const auto view = chunk_of_noise(chunk);
    parallel_for(c.threads, static_cast<int>(open.size()), [&](int k) {
      auto& r = *open[static_cast<std::size_t>(k)];
      r.stepper->advance(r.states, view);
    });
  }
  for (auto* r : open) measure(*r, enough);
  for (const auto& r : runs) report_long_run(r, dt, {"casimir", r.scheme->info.name, out});
}

}  // namespace polhode
