// SPDX-License-Identifier: Apache-2.0
#include "experiments/casimir/casimir_long_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/casimir/casimir_drift.hpp"
#include "experiments/casimir/drift_growth.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {
namespace {

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
  drift_growth drift;

  void measure(const model& m, std::span<const double> start, double n) {
    const auto d = casimir_drifts(m, states, start);
    double square = 0;
    for (const double x : d) square += x * x / block_lanes;
    drift.steps.push_back(n);
    drift.rms.push_back(std::sqrt(square));
    drift.largest.push_back(std::ranges::max(d));
  }
};

report::verdict judge_long_run(const long_run& run, const std::optional<order_fit>& law) {
  const double judged = run.drift.judged();
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
      fmt::format("largest relative drift {:.1e} per 10^6 steps, over {:.0e} steps{}", judged, run.drift.steps.back(),
                  law ? fmt::format("; grows like n^{:.2f}", law->order) : ""));
}

void report_long_run(const long_run& run, double dt, recorder record) {
  const auto& [steps, rms, largest] = run.drift;
  curve drift{{"drift_over_steps", "casimir", "relative", "sampled"}, report::step_count, "1"};
  drift.at = {at_dt(dt)};
  for (std::size_t i = 0; i < steps.size(); ++i) drift.add(steps[i], rms[i], std::nullopt, largest[i]);
  const auto law = run.drift.law();
  const auto written = record.series(drift, law);
  record.verdict("Casimirs kept to rounding", judge_long_run(run, law), {written});
}

}  // namespace

void report_long_runs(const context& c, bool dear, noise_log& log, report::results& out) {
  const auto& s = c.subject;
  const int chunks = chunks_of(c, dear);
  const double dt = finest_step(s);
  std::vector<long_run> runs;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact) runs.push_back({&scheme, scheme.make(dt), replicated(s.scene.momentum), {}});
  if (runs.empty()) return;
  increment_buffer noise(*s.model, chunk_steps, any_needs_areas(s.schemes), {c.generator, noise_quality::fast});
  const auto chunk_of_noise = [&](int chunk) {
    const auto first = static_cast<std::uint64_t>(chunk) * chunk_steps;
    return !s.model->layout().silent() ? noise.fill(c.seed, 0, first, chunk_steps, dt) : silence(chunk_steps);
  };
  const auto advance = [&](const std::vector<long_run*>& those, const increment_view& view) {
    parallel_for(c.threads, static_cast<int>(those.size()), [&](int k) {
      auto& r = *those[static_cast<std::size_t>(k)];
      r.stepper->advance(r.states, view);
    });
  };
  const auto measure = [&](const std::vector<long_run*>& those, int done) {
    for (auto* r : those) r->measure(*s.model, s.scene.momentum, static_cast<double>(done) * chunk_steps);
  };
  std::vector<long_run*> every;
  for (auto& r : runs) every.push_back(&r);
  double next = 1;
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const auto view = chunk_of_noise(chunk);
    if (!view.silent()) log.add(0, view, dt);
    advance(every, view);
    if (chunk + 1 >= next) {  // at 1, 2, 4, … chunks
      measure(every, chunk + 1);
      next *= 2;
    }
    if (chunk % 50 == 0) c.progress(0.9 * chunk / chunks);
  }
  if (every.front()->drift.steps.back() < static_cast<double>(chunks) * chunk_steps) measure(every, chunks);
  auto open = every;
  std::erase_if(open, [](const long_run* r) { return !r->drift.has_to_go_on(); });
  const int enough = static_cast<int>(judged_steps) / chunk_steps;
  for (int chunk = chunks; chunk < enough && !open.empty(); ++chunk) advance(open, chunk_of_noise(chunk));
  measure(open, enough);
  for (const auto& r : runs) report_long_run(r, dt, {"casimir", r.scheme->info.name, out});
}

}  // namespace polhode
