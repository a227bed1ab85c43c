// SPDX-License-Identifier: Apache-2.0
// Does a scheme stay on its coadjoint orbit?
//
// Schemes that claim to keep the Casimirs run for millions of steps: only rounding may show, and its growth law is
// reported. For the others the drift over a fixed time is measured against dt, and its order is held against the claim.
#include <fmt/format.h>

#include "ensemble/noise/paths.hpp"
#include "experiments/casimir/casimir_drift.hpp"
#include "experiments/casimir/casimir_long_run.hpp"
#include "experiments/casimir/drift_growth.hpp"
#include "experiments/casimir/poisson_map.hpp"
#include "experiments/common/dear_experiments.hpp"
#include "experiments/common/rounding_floor.hpp"
#include "experiments/common/sequential.hpp"

namespace polhode {
namespace {

void run(const context& c, bool dear, report::results& out) {
  noise_log log(*c.subject.model, blocks_of(most_drift_paths(c)), {{"", 0}, {"precise", 0}});
  report_long_runs(c, dear, log, out);
  report_casimir_drift(c, log, out);
  log.report("casimir", out);
  for (const auto& scheme : c.subject.schemes) {
    recorder record("casimir", scheme.info.name, out);
    report_floor("state at the rounding floor", rounding_floor_of(c, c.subject, scheme).state, record);
    report_poisson_map(c, record);
  }
}

expected_work work_of(const subject& s, effort e, bool dear) { return {steps_of_long_run(s, e, dear), 0.01}; }

}  // namespace

experiment casimir_experiment() {
  return {
      {"casimir",
       "Does the scheme stay on the coadjoint orbit on which it started?",
       {fmt::format(
            "Schemes that claim it run for a million steps and more on {} paths at the scene's finest dt (at "
            "effort quick a fifth of it and less where a state has more than three components or lies in a field, or "
            "noise depends on it, taken on to a million as the drift grows); a relative drift of {:g} per million "
            "steps is the "
            "bound. Plotted: root mean "
            "square over the paths; "
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
      [](const subject& s, effort e) { return work_of(s, e, false); },
      [](const subject&) -> std::optional<std::string> { return std::nullopt; },
      [](const context& c, report::results& out) { run(c, false, out); }};
}

experiment dear_casimir_experiment() {
  auto e = casimir_experiment();
  e.work = [](const subject& s, effort level) { return work_of(s, level, true); };
  e.run = [](const context& c, report::results& out) { run(c, true, out); };
  return e;
}

}  // namespace polhode
