// SPDX-License-Identifier: Apache-2.0
#include "run/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>

#include "ensemble/coadjoint_matrices.hpp"
#include "ensemble/observing/sphere_bins.hpp"
#include "ensemble/simulation.hpp"
#include "platform/isa.hpp"
#include "platform/memory.hpp"
#include "problem/observables.hpp"
#include "reports/model/errors.hpp"
#include "run/bind_scene.hpp"
#include "run/cache_key.hpp"
#include "run/foreign_runs.hpp"
#include "run/machine_options.hpp"
#include "run/provenance.hpp"
#include "scene/nearest.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

constexpr double most_steps = 1e9, memory_share = 0.8;
const std::vector<std::string> noises{"common", "independent", "none"}, starts{"uniform", "momentum", "orbit"},
    qualities{"fast", "precise"};

const scheme_entry& chosen_scheme(const subject& s, const std::string& name) {
  std::vector<std::string> known;
  for (const auto& e : s.schemes) known.emplace_back(e.info.name);
  return s.schemes[choose("--scheme", name, known)];
}

std::int64_t checked_steps(const scene& s, double dt) {
  const auto value = fmt::format("{}", dt);
  if (!std::isfinite(dt) || dt <= 0) refuse("--dt", value, "accepted: a number above 0");
  const double steps = std::max(1.0, std::round(s.horizon / dt));
  if (steps > most_steps)
    refuse("--dt", value,
           fmt::format("{:.3g} steps to horizon = {}; accepted: at most {:g} steps, dt from {:.6g}", steps, s.horizon,
                       most_steps, s.horizon / most_steps));
  if (!(std::abs(steps * dt - s.horizon) <= 1e-9 * s.horizon))
    refuse("--dt", value,
           fmt::format("horizon = {} is no whole number of steps; accepted: horizon/n, the nearest is {}", s.horizon,
                       s.horizon / steps));
  return static_cast<std::int64_t>(steps);
}

std::vector<std::int64_t> checked_snapshots(const scene& s, const simulate_options& o, std::int64_t steps) {
  std::vector<std::int64_t> stops;
  for (const double time : o.snapshots) {
    if (!(time > 0) || !(time <= s.horizon * (1 + 1e-9)))
      refuse("--snapshots", fmt::format("{}", time),
             fmt::format("accepted: times above 0 and up to horizon = {}", s.horizon));
    stops.push_back(std::clamp<std::int64_t>(std::llround(time / o.dt), 1, steps));
  }
  std::ranges::sort(stops);
  stops.erase(std::ranges::unique(stops).begin(), stops.end());
  return stops;
}

std::int64_t checked_interval(const simulate_options& o, std::int64_t steps) {
  if (o.record_every == 0) return 0;
  const double n = std::round(o.record_every / o.dt);
  if (!(n >= 1) || !(std::fabs(n * o.dt - o.record_every) <= 1e-9 * o.record_every) || n > static_cast<double>(steps))
    refuse("--record", fmt::format("{}", o.record_every),
           fmt::format("accepted: a multiple of --dt = {}, up to the horizon", o.dt));
  return static_cast<std::int64_t>(n);
}

void check_memory(const simulation_plan& p, const model& m, const kernel& k) {
  // The files of the final states are made in memory, too.
  const double file = p.keep_states ? 8.0 * m.dimension() * static_cast<double>(p.bodies) : 0;
  const double needed = simulation_bytes(m, k, p) + file;
  const double available = available_memory();
  if (needed > memory_share * available)
    refuse("--bodies", fmt::format("{}", p.bodies),
           fmt::format("needs {:.1f} MiB of memory ({} steps, {} snapshots); accepted: what fits into {:.1f} MiB, {:g} "
                       "% of the memory available{}",
                       needed / 0x1p20, p.steps, p.snapshots.size(), memory_share * available / 0x1p20,
                       100 * memory_share, p.keep_states ? "; --no-final keeps no states" : ""));
}

struct prepared_run {
  polhode::subject subject;
  const scheme_entry* scheme;
  std::unique_ptr<kernel> stepper;
  simulation_plan plan;
};

prepared_run prepare(const scene& s, const simulate_options& o) {
  apply_isa(o.isa);
  prepared_run r{bind_scene(s, o.foreign), nullptr, nullptr, {}};
  require_scale(r.subject);
  auto& p = r.plan;
  r.scheme = &chosen_scheme(r.subject, o.scheme);
  p.noise = static_cast<ensemble_noise>(choose("--noise", o.noise, noises));
  const bool sphere = r.subject.sphere().has_value();
  const auto usual = p.noise == ensemble_noise::independent ? ensemble_start::momentum
                     : sphere                               ? ensemble_start::uniform
                                                            : ensemble_start::orbit;
  p.start = o.start.empty() ? usual : static_cast<ensemble_start>(choose("--start", o.start, starts));
  p.momentum = s.momentum;
  p.steps = checked_steps(s, o.dt);
  if (o.bodies < 1) refuse("--bodies", fmt::format("{}", o.bodies), "accepted: a positive integer");
  p.bodies = o.bodies;
  p.snapshots = checked_snapshots(s, o, p.steps);
  p.record_every = checked_interval(o, p.steps);
  if (p.record_every > 0 && o.among != nullptr && o.among->size() > 1)
    refuse("--record", fmt::format("{}", o.record_every), "accepted in a run of one process");
  p.record = o.record;
  p.keep_states = o.final_states;
  p.with_areas = r.scheme->needs_areas;
  p.seed = o.seed;
  p.source = {generator_named(o.generator),
              choose("--normals", o.normals, qualities) == 0 ? noise_quality::fast : noise_quality::precise};
  p.threads = o.threads;
  if (!sphere && p.start == ensemble_start::uniform)
    refuse("--start", "uniform", "accepted for this system: orbit, momentum");
  const auto kept = kept_vector(*r.subject.model);
  if (!kept && !p.snapshots.empty())
    refuse("--snapshots", fmt::format("{}", o.snapshots.front()),
           "accepted for systems that keep the length of three components, whose direction is counted");
  p.pictured = kept.value_or(0);
  r.stepper = r.scheme->make(o.dt);
  check_memory(p, *r.subject.model, *r.stepper);
  return r;
}

/// Observables that are components, where the system lists all of them; empty for a system on a sphere.
std::vector<std::string> component_names(const scene& s, const subject& of) {
  if (of.sphere()) return {};
  std::vector<std::string> out;
  for (const auto& o : find_system(s.system)->observables)
    if (o.name != "energy" && o.name.find('^') == std::string::npos) out.emplace_back(o.name);
  const auto dimension = static_cast<std::size_t>(of.model->dimension());
  if (out.size() == dimension) return out;
  out.clear();
  for (std::size_t k = 1; k <= dimension; ++k) out.push_back(fmt::format("mu_{}", k));
  return out;
}

report::ensemble_state described(const ensemble_moments& m, std::int64_t step, double dt) {
  const auto both = [](const running_moments& x) { return report::mean_and_deviation{x.mean, x.deviation()}; };
  report::ensemble_state out{static_cast<double>(step) * dt, step, m.lost, both(m.energy), {}, m.casimir_change};
  for (const auto& c : m.components) out.components.push_back(both(c));
  return out;
}

std::vector<std::string> remarks_on(const scene& s, const prepared_run& r) {
  std::vector<std::string> out;
  const auto& m = *r.subject.model;
  if (m.layout().silent() || r.plan.noise == ensemble_noise::none)
    out.emplace_back(dissipation_of(s) > 0
                         ? "without noise the attractor is the set of equilibria, and no number is drawn"
                         : "without noise and dissipation every body stays on its orbit; no number is drawn");
  if (r.plan.with_areas && m.layout().active_pairs() > 0 && r.plan.noise != ensemble_noise::none)
    out.emplace_back("areas are drawn from the weak surrogate: right in law to weak order two, not path by path");
  return out;
}

void take_over(simulated&& run, const prepared_run& r, report::simulation& out) {
  const auto& p = r.plan;
  out.numbers_drawn = run.drawn;
  out.states = std::move(run.states);
  out.final = described(run.final, p.steps, out.dt);
  for (std::size_t i = 0; i < p.snapshots.size(); ++i) {
    auto& s = run.snapshots[i];
    out.snapshots.push_back({described(s.moments, p.snapshots[i], out.dt), std::move(s.counts), longitude_bins::heights,
                             longitude_bins::longitudes, std::move(s.picture), hemisphere_bins::side});
  }
}

report::simulation frame_of(const scene& s, const simulate_options& o, const prepared_run& r) {
  const auto& p = r.plan;
  report::simulation out;
  out.provenance = build_provenance();
  out.provenance.seed = p.seed;
  out.provenance.generator = o.generator;
  out.normals = o.normals;
  out.provenance.threads = p.threads;
  out.provenance.isa = name_of(active_isa());
  out.scene = s;
  out.scheme = described(*r.scheme);
  out.dt = o.dt;
  out.steps = p.steps;
  out.bodies = p.bodies;
  out.noise = noises[static_cast<std::size_t>(p.noise)];
  out.components = component_names(s, r.subject);
  out.pictured = p.pictured;
  out.start = starts[static_cast<std::size_t>(p.start)];
  out.path_steps = static_cast<double>(p.bodies) * static_cast<double>(p.steps);
  out.remarks = remarks_on(s, r);
  return out;
}

/// Of each process its bodies, and the first joins them.
void share(simulation_plan& plan, const ranks& among) {
  plan.rank = among.rank();
  plan.ranks = among.size();
  plan.join = [&among](ensemble_progress& at) {
    std::string mine;
    if (among.rank() > 0)
      at.write([&](const void* bytes, std::size_t count) { mine.append(static_cast<const char*>(bytes), count); });
    among.to_the_first(mine, [&](const std::string& theirs) {
      std::size_t next = 0;
      auto other = at;
      other.read([&](void* bytes, std::size_t count) {
        if (count > theirs.size() - next) throw output_error("another rank's bodies do not fit to this one's");
        theirs.copy(static_cast<char*>(bytes), count, next);  // count may be 0, and bytes null
        next += count;
      });
      at.join(other);
    });
  };
}

using monotonic = std::chrono::steady_clock;

/// A run that takes up what was saved of it and saves itself now and then.
class saved_run {
 public:
  saved_run(const scene& s, const simulate_options& o, simulation_plan& plan) : every_(o.save_every) {
    if (o.checkpoints == nullptr || plan.record_every > 0 || !o.foreign.empty()) return;
    const auto key = simulation_key(s, o.scheme, o.dt, plan);
    if (key.empty()) return;
    postpone(0);
    plan.resume = [=, this, &plan, store = o.checkpoints](ensemble_progress& at) {
      if (!store->load(key, [&](const byte_source& bytes) { at.read(bytes); })) return;
      const auto blocks = std::ceil(static_cast<double>(plan.bodies) / block_lanes);
      resumed_at_ = at.steps_done(plan.steps) / (static_cast<double>(plan.steps) * blocks);
    };
    plan.save_due = [this] { return monotonic::now() >= next_.load(); };
    plan.save = [=, this, store = o.checkpoints](const ensemble_progress& at) {
      const auto begun = monotonic::now();
      store->save(key, [&](const byte_sink& bytes) { at.write(bytes); });
      postpone(std::chrono::duration<double>(monotonic::now() - begun).count());
    };
  }

  double resumed_at() const { return resumed_at_; }

 private:
  void postpone(double seconds_of_a_save) {
    constexpr double share = 50;  // of the time goes into saving: one part at most
    const std::chrono::duration<double> pause{std::max(every_, share * seconds_of_a_save)};
    next_ = monotonic::now() + std::chrono::duration_cast<monotonic::duration>(pause);
  }

  double every_, resumed_at_ = 0;
  std::atomic<monotonic::time_point> next_{};
};

}  // namespace

void check_simulation(const scene& s, const simulate_options& o) { prepare(s, o); }

recording_plan planned_recording(const scene& s, const simulate_options& o) {
  const auto r = prepare(s, o);
  recording_plan out{r.plan.bodies, r.plan.records(), {}, 0};
  for (std::size_t k = 0; k < s.momentum.size(); ++k) out.components.push_back(component_name(r.subject, k));
  out.dt = static_cast<double>(r.plan.record_every) * o.dt;
  return out;
}

report::simulation simulate(const scene& s, const simulate_options& o, const progress_sink& progress) {
  auto r = prepare(s, o);
  auto out = frame_of(s, o, r);
  if (o.among != nullptr) share(r.plan, *o.among);
  saved_run saved(s, o, r.plan);
  const auto tell = [&](double share) {
    if (progress) progress(share, o.scheme);
  };
  const auto begun = std::chrono::steady_clock::now();
  const auto cpu_begun = std::clock();
  take_over(simulate_ensemble(*r.subject.model, *r.stepper, r.plan, tell), r, out);
  agree(o.foreign, o.among);
  for (const auto& one : o.foreign)
    if (const auto why = one->failure(); why && one->about().name == o.scheme)
      throw output_error(fmt::format("{}: {}", o.scheme, *why));
  out.provenance.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  out.provenance.cpu_seconds = static_cast<double>(std::clock() - cpu_begun) / CLOCKS_PER_SEC;
  out.resumed_at = saved.resumed_at();
  if (const double rest = 1 - out.resumed_at; rest > 0)
    out.ns_per_path_step = 1e9 * out.provenance.wall_seconds / (out.path_steps * rest);
  return out;
}

}  // namespace polhode
