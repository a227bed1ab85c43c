// SPDX-License-Identifier: Apache-2.0
#include "experiments/casimir/casimir_long_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

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
int chunks_of(const subject& s, effort e, bool dear) {
  if (dear) return 100;
  if (e == effort::quick && dear_steps(s)) return std::max(40, 600 / s.model->dimension());
  return by_effort(e, 1000, 2500, 10'000);
}

/// One scheme on one block of paths for a long time.
struct long_run {
  const scheme_entry* scheme;
  std::unique_ptr<kernel> stepper;
  std::vector<double> states;
  drift_growth drift;
  double seconds = 0;  ///< of the chunks so far: the dearest go first

  void advance(const increment_view& noise) {
    const auto begun = std::chrono::steady_clock::now();
    stepper->advance(states, noise);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  }

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

/// Runs side by side, one chunk of noise after the other. The next one is drawn meanwhile.
class runs_under_one_noise {
 public:
  runs_under_one_noise(const context& c, double dt, bool areas)
      : c_(c), dt_(dt), silent_(c.subject.model->layout().silent()), view_(silence(chunk_steps)) {
    for (int k = 0; k < 2 && !silent_; ++k)
      held_.emplace_back(*c.subject.model, chunk_steps, areas, noise_source{c.generator, noise_quality::fast});
    view_ = draw(0);
  }

  /// Of the chunk that is advanced over next.
  const increment_view& noise() const { return view_; }

  void advance(const std::vector<long_run*>& those) {
    auto next = view_;
    parallel_for(c_.threads, static_cast<int>(those.size()) + 1, [&](int k) {
      if (k == 0)
        next = draw(done_ + 1);
      else
        those[static_cast<std::size_t>(k - 1)]->advance(view_);
    });
    view_ = next;
    ++done_;
  }

 private:
  increment_view draw(int chunk) {
    if (silent_) return silence(chunk_steps);
    auto& buffer = held_[static_cast<std::size_t>(chunk % 2)];
    return buffer.fill(c_.seed, 0, static_cast<std::uint64_t>(chunk) * chunk_steps, chunk_steps, dt_);
  }

  const context& c_;
  double dt_;
  bool silent_;
  int done_ = 0;
  increment_view view_;
  std::vector<increment_buffer> held_;
};

void measure(const context& c, const std::vector<long_run*>& those, int chunks) {
  const auto& s = c.subject;
  for (auto* run : those) run->measure(*s.model, s.scene.momentum, static_cast<double>(chunks) * chunk_steps);
}

/// At 1, 2, 4, ... chunks, and at the last.
void run_all(const context& c, int chunks, std::vector<long_run*> those, runs_under_one_noise& together,
             noise_log& log) {
  int next = 1;
  for (int done = 0; done < chunks;) {
    if (!together.noise().silent()) log.add(0, together.noise(), finest_step(c.subject));
    together.advance(those);
    if (++done == 1) std::ranges::sort(those, std::greater{}, &long_run::seconds);
    if (done == next || done == chunks) measure(c, those, done);
    if (done == next) next *= 2;
    if (done % 50 == 0) c.progress(0.9 * done / chunks);
  }
}

/// Twice as far each time, while a drift that was guessed would be refuted if it were measured.
void go_on(const context& c, int done, std::vector<long_run*> open, runs_under_one_noise& together) {
  constexpr int enough = static_cast<int>(judged_steps) / chunk_steps;
  const auto decided = [](const long_run* run) { return !run->drift.has_to_go_on(); };
  for (std::erase_if(open, decided); !open.empty(); std::erase_if(open, decided)) {
    for (const int next = std::min(2 * done, enough); done < next; ++done) together.advance(open);
    measure(c, open, done);
  }
}

}  // namespace

double steps_of_long_run(const subject& s, effort e, bool dear) {
  return static_cast<double>(chunks_of(s, e, dear)) * chunk_steps * block_lanes;
}

void report_long_runs(const context& c, bool dear, noise_log& log, report::results& out) {
  const auto& s = c.subject;
  const double dt = finest_step(s);
  std::vector<long_run> runs;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact) runs.push_back({&scheme, scheme.make(dt), replicated(s.scene.momentum), {}});
  if (runs.empty()) return;
  std::vector<long_run*> every;
  for (auto& r : runs) every.push_back(&r);
  const bool areas = std::ranges::any_of(runs, [](const long_run& r) { return r.scheme->needs_areas; });
  runs_under_one_noise together(c, dt, areas);
  const int chunks = chunks_of(s, c.effort, dear);
  run_all(c, chunks, every, together, log);
  go_on(c, chunks, every, together);
  for (const auto& r : runs) report_long_run(r, dt, {"casimir", r.scheme->info.name, out});
}

}  // namespace polhode
