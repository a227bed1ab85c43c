// SPDX-License-Identifier: Apache-2.0
// Without noise: does the energy follow dh/dt = -theta |ad*_dh mu|^2, and how fast does the path converge?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/rounding_floor.hpp"
#include "experiments/energy/energy_law.hpp"
#include "experiments/energy/energy_trace.hpp"
#include "problem/subject.hpp"
#include "problem/vectors.hpp"
#include "references/odeint.hpp"
#include "sphere/equilibria.hpp"

namespace polhode {
namespace {

// Dissipation without noise takes a free body to rotation about the axis of least energy; in a field to one of the
// wells of h.

constexpr double end_bound = 1e-6;  // of the energy's range: how near the least energy a path must end
constexpr int least_axis_time_scales = 60;
constexpr double most_end_steps = 1e6;
constexpr const char* end_claim = "ends on the axis of least energy";

/// Of what is left of a motion in the flattest well; along a ring of wells nothing decays.
double slowest_decay(const sphere_problem& p, const std::vector<equilibrium>& all) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& e : all)
    if (e.is_least()) least = std::min(least, e.curvature[0] > 0 ? e.curvature[0] : e.curvature[1]);
  return p.damping * p.radius * p.radius * least;
}

/// Of the energy's range on the sphere that was reached: in a field its wells lie elsewhere than on the scene's.
double above_nearest_well(sphere_problem p, const Eigen::Vector3d& end) {
  if (!end.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  p.radius = end.norm();
  const auto all = equilibria(p);
  const double energy = p.energy(end);
  double above = std::numeric_limits<double>::infinity();
  for (const auto& e : all)
    if (e.is_least() && !(std::fabs(energy - e.energy) > std::fabs(above))) above = energy - e.energy;
  return above / (all.back().energy - all.front().energy);
}

/// Runs until every motion has died out and looks where it ended. Open where that takes too many steps; nothing where
/// the system does not live on a sphere.
void report_end(const subject& s, const scheme_entry& scheme, recorder& record) {
  if (!s.sphere()) return;
  const auto& p = *s.sphere();
  const auto all = equilibria(p);
  const double rate = fastest_rate(s);
  const double time = least_axis_time_scales / slowest_decay(p, all), dt = 0.05 / rate;
  if (time / dt > most_end_steps) {
    record.verdict(end_claim,
                   {.reason = fmt::format("the slowest decay needs {:.1e} steps, at most {:g} are affordable",
                                          time / dt, most_end_steps)});
    return;
  }
  const int steps = static_cast<int>(time / dt);
  const auto stepper = scheme.make(dt);
  auto states = replicated(s.scene.momentum);
  stepper->advance(states, silence(steps));
  const auto end = lane_of(states, 0, s.model->dimension());
  const double above = above_nearest_well(p, Eigen::Vector3d(end.data()));
  record.verdict(
      end_claim,
      judge_distance({above, above, above}, end_bound,
                     fmt::format("after time {:.3g}: {:.1e} of the energy's range above the least", time, above)));
}

bool at_rest(const subject& s) {
  std::vector<double> drift(s.scene.momentum.size());
  s.model->drift(s.scene.momentum, drift);
  return length(drift) <= 1e-12 * fastest_rate(s) * length(s.scene.momentum);
}

std::vector<double> solved_end(const subject& s, double t) {
  return solve_drift([&](std::span<const double> mu, std::span<double> out) { s.model->drift(mu, out); },
                     s.scene.momentum, t);
}

/// The same with a horizon over which something happens, whatever the scene's own.
subject over_time_scales(subject s) {
  s.scene.horizon = std::max(s.scene.horizon, 4 / fastest_rate(s));
  return s;
}

void run(const context& c, report::results& out) {
  const auto damped = c.subject.without_noise();
  const auto free = damped.without_dissipation();
  const auto grid = asymptotic_levels(over_time_scales(damped), by_effort(c.effort, 256.0, 256.0, 1024.0));
  const auto damped_end = solved_end(damped, grid.horizon);
  const auto& closed_form = free.offers->free;
  const auto free_end = closed_form ? closed_form->at(grid.horizon) : solved_end(free, grid.horizon);
  const std::string free_method = closed_form ? closed_form->method : "odeint";
  const bool dissipates = dissipation_of(damped.scene) > 0;
  if (!dissipates)
    out.skipped.push_back(
        {"energy", "", "decay and end point: theta = 0, nothing dissipates; the free rotation is measured"});
  std::vector<report::results> parts(damped.schemes.size());
  progress_counter done(static_cast<int>(parts.size()), c.progress);
  parallel_for(c.threads, static_cast<int>(parts.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& scheme = damped.schemes[k];
    recorder record("energy", scheme.info.name, parts[k]);
    if (dissipates) {
      report_convergence(damped, scheme, grid, {"", "odeint", damped_end}, record);
      report_end(damped, scheme, record);
    }
    report_convergence(free, free.schemes[k], grid, {"free_", free_method, free_end}, record);
    report_floor("energy at the rounding floor", rounding_floor_of(c, damped, scheme).energy, record);
    done.add();
  });
  for (const auto& part : parts) {
    out.measurements.insert(out.measurements.end(), part.measurements.begin(), part.measurements.end());
    out.fits.insert(out.fits.end(), part.fits.begin(), part.fits.end());
    out.verdicts.insert(out.verdicts.end(), part.verdicts.begin(), part.verdicts.end());
    out.skipped.insert(out.skipped.end(), part.skipped.begin(), part.skipped.end());
  }
  report_energy_trace(c, out);
}

expected_work work_of(const subject& s, effort e) { return {by_effort(e, 4e5, 4e5, 1e6), s.sphere() ? 0.02 : 0}; }

}  // namespace

experiment energy_experiment() {
  return {
      {"energy",
       "Without noise, does the energy follow dh/dt = -theta |Pi x Omega|^2, and does the path converge?",
       {"sigma = 0 but for the trace formula. Path: against Boost.Odeint (Fehlberg 7(8), 1e-14 per step), and for "
        "theta = 0 against "
        "Jacobi's elliptic functions.",
        "Energy law: the largest |h(t) - h(0) + integral of theta |Pi x Omega|^2| along the scheme's own path.",
        "Steps are halved until a slope has settled and is known well, or rounding hides it. Rounding floor of the "
        "energy: as that of the state in experiment casimir, in units of what the smallest error of the state does to "
        "the energy, or of the energy's own where that is more.",
        "An order above the claim holds: some scenes are kinder than the claim.",
        "Trace formula: theta = 0 and the scene's noise, which alone moves E[h] then; under isotropic noise E[h] = m + "
        "(h_0 - m) exp(-3 sigma^2 t) at all times, m the mean over the sphere. The error of one step, over dt, from "
        "points all over the sphere, by quadrature over the noise; judged like the weak errors (experiment weak). Of "
        "schemes that keep the sphere it bounds the error of E[h] at any time, however late."}},
      work_of,
      [](const subject& s) -> std::optional<std::string> {
        if (at_rest(s)) return "the initial momentum is an equilibrium: nothing moves without noise";
        return std::nullopt;
      },
      run};
}

}  // namespace polhode
