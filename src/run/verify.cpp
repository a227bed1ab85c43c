// SPDX-License-Identifier: Apache-2.0
#include "run/verify.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>

#include "platform/isa.hpp"
#include "reports/model/errors.hpp"
#include "run/forecast.hpp"
#include "run/foreign_runs.hpp"
#include "run/machine_options.hpp"
#include "run/measured_claims.hpp"
#include "run/provenance.hpp"
#include "run/run_experiment.hpp"
#include "run/timing.hpp"
#include "scene/nearest.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

/// Adding an experiment: its source, and its name here.
std::vector<experiment> all_experiments() {
  return {casimir_experiment(),   strong_experiment(),        energy_experiment(),   gibbs_experiment(),
          weak_experiment(),      attractor_experiment(),     lyapunov_experiment(), modified_experiment(),
          stability_experiment(), work_precision_experiment()};
}

/// Keeps the wanted ones in the list's own order; throws on a name that is neither there nor `known` otherwise.
template <class T, class Name>
void keep_wanted(std::vector<T>& all, const std::vector<std::string>& wanted, const char* option, Name name,
                 std::vector<std::string> known = {}) {
  if (wanted.empty()) return;
  for (const T& t : all) known.emplace_back(name(t));
  for (const auto& w : wanted) choose(option, w, known);
  std::erase_if(all, [&](const T& t) { return std::ranges::find(wanted, name(t)) == wanted.end(); });
}

/// Names of integrators that do not run on this scene.
std::vector<std::string> refusing(const foreign::foreign_schemes& all) {
  std::vector<std::string> out;
  for (const auto& one : all)
    if (!one->refusal().empty()) out.push_back(one->about().name);
  return out;
}

std::string effort_name(effort e) { return by_effort<std::string>(e, "quick", "standard", "thorough"); }

/// What was skipped appears among the verdicts too, so that the board has no silent holes.
void add_skipped_verdicts(report::results& out) {
  for (const auto& skip : out.skipped)
    for (const auto& scheme : out.schemes)
      if (skip.scheme.empty() || skip.scheme == scheme.name)
        out.verdicts.push_back(
            {skip.experiment, scheme.name, "", {}, {}, {}, {}, report::verdict_kind::skipped, skip.reason});
}

report::results finished(report::results out, const stopwatch& watch) {
  add_skipped_verdicts(out);
  watch.read(out.provenance);
  return out;
}

/// On the schemes by how they may be asked.
void run_on_parts(const experiment& e, const context& c, const verify_options& options, const shared_work* shared,
                  report::results& out) {
  kept_results kept{options.store, {}, options.among, shared, options.budget.get()};
  for (const auto& one : options.foreign) kept.but_of.push_back(one->about().name);
  const auto parts = parts_for(e, c.subject, options.foreign, out);
  for (const auto& part : parts) {
    const context on_part{part.subject, c.effort, c.threads, c.seed, c.generator, c.progress, c.before};
    if (&part == &parts.front()) {
      run_experiment(part.experiment, on_part, kept, out);
      continue;
    }
    report::results more;
    run_experiment(part.experiment, on_part, kept, more);
    append_of_schemes(part.subject, std::move(more), out);
  }
  agree(options.foreign, options.among);
  report_failures(e, c.subject, options.foreign, out);
  excuse_unclaimed(options.foreign, c.subject.model->noise(), out);
}

/// What the budget ends is left out as a whole, as half an experiment says nothing, and remains to come.
bool run_in_time(const experiment& e, const context& c, const verify_options& options, const shared_work* shared,
                 report::results& out) {
  if (const auto reason = e.skip_reason(c.subject)) {
    out.skipped.push_back({e.info.name, "", *reason});
    return true;
  }
  const auto* when = shared != nullptr                             ? ""  // begun by some of the processes
                     : options.budget && options.budget->used_up() ? " before"
                                                                   : " meanwhile";
  auto before = out;
  try {
    run_on_parts(e, c, options, shared, out);
    return true;
  } catch (const out_of_time&) {
    agree(options.foreign, options.among);  // on what one has found before its time was up
    out = std::move(before);
    out.skipped.push_back(
        {e.info.name, "",
         fmt::format("the budget of {:g} s was used up{} (--budget)", options.budget->seconds(), when)});
    return false;
  }
}

bool is_wanted(std::string_view scheme, const verify_options& options) {
  return options.schemes.empty() || std::ranges::find(options.schemes, scheme) != options.schemes.end();
}

/// Of an experiment in the time of a run: none of them takes no time at all.
double weight_of(const expected_cost& e) { return e.cpu_seconds + 0.1; }

void run_experiments(const subject& s, const std::vector<experiment>& experiments, const verify_options& options,
                     const progress_sink& progress, const stopwatch& watch, report::results& out) {
  auto of_schemes = scheme_costs(s, experiments, options);
  if (options.among != nullptr) of_schemes = agreed(of_schemes, *options.among);
  const auto costs = forecast(experiments, of_schemes);
  if (options.beforehand) options.beforehand(costs);
  double total = 0, before = 0;
  for (const auto& e : costs) {
    total += weight_of(e);
    out.to_come.push_back(e.experiment);
  }
  const auto tell_of = [&](std::string_view what, double seconds) {
    if (progress) progress((before + seconds) / total, what);
  };
  experiment_profile profile(options.profile);
  // One from elsewhere is asked in a form of its own, so nothing is shared beforehand.
  sharing shares(experiments, of_schemes, options.foreign.empty() ? options.among : nullptr, options.budget.get());
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const auto& e = experiments[i];
    const double weight = weight_of(costs[i]);
    const auto tell = [&](double share) { tell_of(e.info.name, weight * share); };
    profile.begin();
    tell(0);
    const context c{s, options.effort, options.threads, options.seed, generator_named(options.generator), tell, &out};
    const auto* shared = shares.of(i, c, [&](double seconds) { tell_of("shared experiments", seconds); });
    out.experiments.push_back(e.info);
    if (run_in_time(e, c, options, shared, out)) std::erase(out.to_come, e.info.name);
    profile.end(e.info.name, out.profile);
    before += weight;
    if (options.so_far && &e != &experiments.back()) options.so_far(finished(out, watch));
  }
  if (progress) progress(1, "done");
}

/// What runs: these schemes on the scene, and these experiments.
std::pair<subject, std::vector<experiment>> wanted_of(subject s, const verify_options& options) {
  auto experiments = all_experiments();
  keep_wanted(
      s.schemes, options.schemes, "--schemes", [](const scheme_entry& e) { return e.info.name; },
      refusing(options.foreign));
  if (!options.schemes.empty()) s = restricted(std::move(s), options.schemes);
  keep_wanted(experiments, options.experiments, "--experiments", [](const experiment& e) { return e.info.name; });
  return {std::move(s), std::move(experiments)};
}

}  // namespace

std::vector<expected_cost> expected_costs(const scene& s, const verify_options& options) {
  apply_isa(options.isa);
  const auto [subject, experiments] = wanted_of(bind_scene(s, options.foreign), options);
  return forecast(experiments, scheme_costs(subject, experiments, options));
}

void check_options(const scene& s, const verify_options& options) {
  apply_isa(options.isa);
  generator_named(options.generator);
  auto subject = bind_scene(s, options.foreign);
  require_scale(subject);
  auto experiments = all_experiments();
  keep_wanted(subject.schemes, options.schemes, "--schemes", [](const scheme_entry& e) { return e.info.name; });
  keep_wanted(experiments, options.experiments, "--experiments", [](const experiment& e) { return e.info.name; });
}

report::results verify_subject(subject whole, const verify_options& options, const progress_sink& progress) {
  gsl_set_error_handler_off();  // GSL's failures come back as values here, not as abort()
  const auto [s, experiments] = wanted_of(std::move(whole), options);
  report::results out;
  out.scene = s.scene;
  out.skipped = s.inapplicable;
  for (const auto& e : s.schemes) out.schemes.push_back(described(e, find_foreign(options.foreign, e.info.name)));
  out.provenance = build_provenance();
  out.provenance.seed = options.seed;
  out.provenance.generator = options.generator;
  out.provenance.effort = effort_name(options.effort);
  out.provenance.threads = options.threads;
  out.provenance.isa = name_of(active_isa());
  const stopwatch watch;
  run_experiments(s, experiments, options, progress, watch, out);
  return finished(std::move(out), watch);
}

report::results verify(const scene& s, const verify_options& options, const progress_sink& progress) {
  apply_isa(options.isa);
  generator_named(options.generator);
  for (const auto& one : options.foreign)
    if (is_wanted(one->about().name, options))
      within(options.budget.get(), [&] { measure_claims(s, one, options.experiments, options.threads, options.seed); });
  agree(options.foreign, options.among);
  return verify_subject(bind_scene(s, options.foreign), options, progress);
}

std::vector<report::experiment> list_experiments() {
  std::vector<report::experiment> out;
  for (const auto& e : all_experiments()) out.push_back(e.info);
  return out;
}

}  // namespace polhode
