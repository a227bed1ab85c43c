// Without noise: does the energy follow dh/dt = -theta |ad*_dh mu|^2, and how fast does the path converge?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/paths.hpp"
#include "experiments/energy_trace.hpp"
#include "experiments/experiment.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/progress_counter.hpp"
#include "experiments/rounding_floor.hpp"
#include "experiments/undecided.hpp"
#include "experiments/vectors.hpp"
#include "references/free_rotation.hpp"
#include "references/odeint.hpp"

namespace polhode {
namespace {

constexpr double rounding = 1e-13;  // of the energy's size: what counts as no rise
constexpr double end_bound = 1e-6;  // of the energy's range: how near the least energy a path must end
constexpr int least_axis_time_scales = 60;
constexpr double most_end_steps = 1e6;
constexpr const char* end_claim = "ends on the axis of least energy";

struct trajectory {
  std::vector<double> energy, rate;  // at every step, and -dh/dt there
  std::vector<double> end;
};

trajectory follow(const subject& s, const scheme_entry& scheme, double horizon, int steps) {
  const auto& m = *s.model;
  const double dt = horizon / steps;
  const auto stepper = scheme.make(dt);
  const auto view = silence(1, dt);
  auto states = replicated(s.scene.momentum);
  trajectory t;
  for (int i = 0;; ++i) {
    t.end = lane_of(states, 0, m.dimension());
    t.energy.push_back(m.energy(t.end));
    t.rate.push_back(m.dissipation_rate(t.end));
    if (i == steps) return t;
    stepper->advance(states, view);
  }
}

/// Largest |h_k - h_0 + integral of the rate|, the integral by Simpson's rule over pairs of steps.
double law_residual(const trajectory& t, double dt) {
  double integral = 0, worst = 0;
  for (std::size_t k = 2; k < t.energy.size(); k += 2) {
    integral += dt / 3 * (t.rate[k - 2] + 4 * t.rate[k - 1] + t.rate[k]);
    const double residual = std::fabs(t.energy[k] - t.energy[0] + integral);
    worst = std::isfinite(residual) ? std::max(worst, residual) : residual;
  }
  return worst;
}

/// The floor of every fit, in units of the state's or the energy's size: ten times what the references (5e-15) and the
/// rounding of so many steps, a random walk, leave.
double relative_floor(double steps) {
  return 10 * (5e-15 + 0.8 * std::numeric_limits<double>::epsilon() * std::sqrt(steps));
}

/// Errors at every level of a grid, and the floor of each.
struct error_series {
  std::vector<double> dt, values, floors;
  std::vector<double> most_rounding;  ///< where every step rounds alike, as a body's that turns about its own axis

  error_series(const level_grid& grid, std::vector<double> errors, double size)
      : dt(grid.dt()), values(std::move(errors)) {
    for (const int n : grid.steps) {
      floors.push_back(size * relative_floor(n));
      most_rounding.push_back(std::max(floors.back(), size * 8 * std::numeric_limits<double>::epsilon() * n));
    }
  }
  /// The first level at its floor after one above it: from there on rounding grows and the error is not seen.
  std::size_t reaches_floor() const {
    std::size_t i = 0;
    while (i < values.size() && values[i] <= floors[i]) ++i;  // a single step has no residual
    while (i < values.size() && !(values[i] <= floors[i])) ++i;
    return i;
  }
  /// The fit takes no notice of what is at its floor, or finer, nor of what rounding moves by more than a fortieth, as
  /// that would bend the line.
  std::optional<order_fit> fit() const {
    auto above = values;
    for (std::size_t i = 0; i < above.size(); ++i)
      if (above[i] <= 4 * floors[i] || i > reaches_floor()) above[i] = 0;
    return fit_order(dt, above, 0);
  }
};

/// Too few levels above the floor for a fit. Errors at the floor throughout are exactness on this scene. Else the fall
/// from the coarsest level to another, each known to a tenth of its floor, bounds the order from below.
void judge_at_floor(const error_series& e, double expected, report::verdict& v) {
  std::size_t first = e.values.size();  // the first level from which on all is at the floor
  while (first > 0 && e.values[first - 1] <= e.floors[first - 1]) --first;
  const bool exact = std::ranges::equal(e.values, e.most_rounding, std::ranges::less_equal{});
  if (exact) {
    v.kind = report::verdict_kind::holds;
    v.reason = fmt::format("exact on this scene: every error at rounding, below {:.1e}", std::ranges::max(e.values));
    return;
  }
  if (first == e.values.size()) return;
  std::size_t top = 0;  // the coarsest above its floor: a single step has no residual
  while (top + 1 < e.values.size() && e.values[top] <= e.floors[top]) ++top;
  double least = 0;
  for (std::size_t j = top + 1; j <= first && j < e.values.size(); ++j)
    least = std::max(least, std::log2((e.values[top] - e.floors[top] / 10) / (e.values[j] + e.floors[j] / 10)) /
                                static_cast<double>(j - top));
  if (least >= expected - order_margin) v.kind = report::verdict_kind::holds;
  v.low = least;
  v.reason = fmt::format("reaches the rounding floor {:.1e} in {} halvings: order at least {:.2f}", e.floors[first],
                         first - top, least);
}

/// An error series with its order.
void report_order(const series& s, const std::string& text, const error_series& e, double expected,
                  report::results& out) {
  const auto fit = e.fit();
  std::vector<report::measurement> points;
  for (std::size_t i = 0; i < e.dt.size(); ++i) points.push_back(measured(s, e.dt[i], e.values[i]));
  record_fit(out, s, fit, std::move(points));
  auto v = judge_order({s.experiment, s.scheme, text}, expected, fit, true);
  if (!fit) judge_at_floor(e, expected, v);
  out.verdicts.push_back(v);
}

/// Counts the steps in which the energy rises by more than rounding.
void report_monotony(const std::string& scheme, std::span<const double> energy, double dt, double tolerance,
                     report::results& out) {
  int rises = 0;
  for (std::size_t k = 1; k < energy.size(); ++k)
    if (!(energy[k] <= energy[k - 1] + tolerance)) ++rises;
  const double count = rises;
  out.verdicts.push_back({"energy", scheme, "energy never rises at the finest dt", 0.0, count, count, count,
                          rises == 0 ? report::verdict_kind::holds : report::verdict_kind::refuted,
                          fmt::format("{} rises in {} steps of {:.3g}", rises, energy.size() - 1, dt)});
}

/// The runs of one scheme at every level.
struct runs_of_levels {
  level_grid grid;
  std::vector<double> state_error, residual;
  trajectory finest;

  void add(const subject& s, const scheme_entry& scheme, int steps, std::span<const double> truth) {
    finest = follow(s, scheme, grid.horizon, steps);
    grid.steps.push_back(steps);
    state_error.push_back(distance(finest.end, truth));
    residual.push_back(law_residual(finest, grid.horizon / steps));
  }
};

/// By width alone: a slope that has settled and is known well enough, or none to be had by halving on.
bool order_is_clear(const error_series& e) {
  const auto fit = e.fit();
  return !fit || e.reaches_floor() < e.values.size() || (fit->settled && half_width(*fit) <= tight_order);
}

/// One scheme on one scene without noise, against the true end point. Where an order is not clear the steps are halved
/// on: nothing is sampled here, and a leading term can be small by accident.
void report_convergence(const subject& s, const scheme_entry& scheme, const level_grid& first, const std::string& what,
                        const std::string& method, std::span<const double> truth, report::results& out) {
  constexpr int most_steps = 1 << 17;
  const std::string name(scheme.info.name);
  const double order = scheme.info.deterministic_order;
  const double energy = std::fabs(s.model->energy(s.scene.momentum));
  runs_of_levels runs{{first.horizon, {}}, {}, {}, {}};
  const auto path = [&] { return error_series(runs.grid, runs.state_error, length(truth)); };
  const auto law = [&] { return error_series(runs.grid, runs.residual, energy); };
  for (const int n : first.steps) runs.add(s, scheme, n, truth);
  while (runs.grid.steps.back() <= most_steps / 2 && !(order_is_clear(path()) && order_is_clear(law())))
    runs.add(s, scheme, 2 * runs.grid.steps.back(), truth);
  report_order({"energy", name, what + "state_error", "state", "|mu|", method},
               what.empty() ? "order of the path" : "order of the free path", path(), order, out);
  report_order({"energy", name, what + "law_residual", "energy", "energy", "deterministic"},
               what.empty() ? "order of the energy law" : "order of the free energy", law(), order, out);
  if (s.scene.theta > 0) report_monotony(name, runs.finest.energy, runs.grid.dt().back(), rounding * energy, out);
}

/// Runs until every motion has died out and looks where it ended.
void report_end(const subject& s, const scheme_entry& scheme, report::results& out) {
  const auto [least, greatest] = std::ranges::minmax(s.scene.inertia);
  const double c = length(s.scene.momentum), range = 0.5 * c * c * (1 / least - 1 / greatest);
  const double rate = fastest_rate(s);
  // The slowest decay: between the two axes of greatest inertia, at rate theta c^2 times their difference of 1/I.
  auto inertia = s.scene.inertia;
  std::ranges::sort(inertia);
  const double gap = inertia[2] > inertia[1] ? 1 / inertia[1] - 1 / inertia[2] : 1 / inertia[0] - 1 / inertia[2];
  const double time = least_axis_time_scales / (s.scene.theta * c * c * gap), dt = 0.05 / rate;
  const std::string name(scheme.info.name);
  if (time / dt > most_end_steps) {
    leave_open(
        {&scheme, 1}, "energy", end_claim,
        fmt::format("the slowest decay needs {:.1e} steps, at most {:g} are affordable", time / dt, most_end_steps),
        out);
    return;
  }
  const int steps = static_cast<int>(time / dt);
  const auto stepper = scheme.make(dt);
  auto states = replicated(s.scene.momentum);
  stepper->advance(states, silence(steps, dt));
  const auto end = lane_of(states, 0, s.model->dimension());
  // Energy of the direction reached, above the least on its sphere.
  const double e = length(end), above = (s.model->energy(end) * c * c / (e * e) - 0.5 * c * c / greatest) / range;
  out.verdicts.push_back(
      judge_distance({"energy", name, end_claim}, {above, above, above}, end_bound,
                     fmt::format("after time {:.3g}: {:.1e} of the energy's range above the least", time, above)));
}

bool at_rest(const subject& s) {
  std::vector<double> drift(s.scene.momentum.size());
  s.model->drift(s.scene.momentum, drift);
  return length(drift) <= 1e-12 * fastest_rate(s) * length(s.scene.momentum);
}

subject without_dissipation(const subject& s) {
  auto scene = s.scene;
  scene.theta = 0;
  return s.with(scene);
}

std::vector<double> true_end(const subject& s, double t) {
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
  const auto free = without_dissipation(damped);
  const auto grid = asymptotic_levels(over_time_scales(damped), by_effort(c.effort, 256.0, 256.0, 1024.0));
  const auto damped_end = true_end(damped, grid.horizon);
  const auto free_end = free_rotation(
      free.scene.inertia, {free.scene.momentum[0], free.scene.momentum[1], free.scene.momentum[2]}, grid.horizon);
  const bool dissipates = damped.scene.theta > 0;
  if (!dissipates)
    out.skipped.push_back(
        {"energy", "", "decay and end point: theta = 0, nothing dissipates; the free rotation is measured"});
  std::vector<report::results> parts(damped.schemes.size());
  progress_counter done(static_cast<int>(parts.size()), c.progress);
  parallel_for(c.threads, static_cast<int>(parts.size()), [&](int k) {
    auto& part = parts[static_cast<std::size_t>(k)];
    if (dissipates) {
      report_convergence(damped, damped.schemes[static_cast<std::size_t>(k)], grid, "", "odeint", damped_end, part);
      report_end(damped, damped.schemes[static_cast<std::size_t>(k)], part);
    }
    report_convergence(free, free.schemes[static_cast<std::size_t>(k)], grid, "free_", "jacobi", free_end, part);
    const auto& scheme = damped.schemes[static_cast<std::size_t>(k)];
    report_floor({"energy", std::string(scheme.info.name), "energy at the rounding floor"},
                 rounding_floor_of(c, damped, scheme).energy, part);
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
        "energy: as that of the state in experiment casimir.",
        "An order above the claim holds: some scenes are kinder than the claim.",
        "Trace formula: theta = 0 and the scene's noise, which alone moves E[h] then; under isotropic noise E[h] = m + "
        "(h_0 - m) exp(-3 sigma^2 t) at all times, m the mean over the sphere. The error of one step, over dt, from "
        "points all over the sphere, by quadrature over the noise; judged like the weak errors (experiment weak). Of "
        "schemes that keep the sphere it bounds the error of E[h] at any time, however late."}},
      1,
      [](const subject& s) -> std::optional<std::string> {
        if (at_rest(s)) return "the initial momentum is an equilibrium: nothing moves without noise";
        return std::nullopt;
      },
      run};
}

}  // namespace polhode
