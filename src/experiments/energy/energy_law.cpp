// SPDX-License-Identifier: Apache-2.0
#include "experiments/energy/energy_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

// Errors without sampling, over levels at which rounding may hide them.

/// Errors at every level of a grid, and the floor of each: ten times what the references (5e-15) and the rounding of so
/// many steps, a random walk, leave, in units of `size`, that of the state or of the energy.
struct floored_errors {
  std::vector<double> dt, values, floors;
  std::vector<double> most_rounding;  ///< where every step rounds alike, as a body's that turns about its own axis

  floored_errors(const level_grid&, std::vector<double> errors, double size);

  /// The first level at its floor after one above it: from there on rounding grows and the error is not seen.
  std::size_t reaches_floor() const;

  /// Takes no notice of what is at its floor, or finer, nor of what rounding moves by more than a fortieth, as that
  /// would bend the line.
  std::optional<order_fit> fit() const;
};

double relative_floor(double steps) {
  return 10 * (5e-15 + 0.8 * std::numeric_limits<double>::epsilon() * std::sqrt(steps));
}

/// Too few levels above the floor for a fit. Errors at the floor throughout are exactness on this scene. Else the fall
/// from the coarsest level to another, each known to a tenth of its floor, bounds the order from below.
void judge_at_floor(const floored_errors& e, double expected, report::verdict& v) {
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

floored_errors::floored_errors(const level_grid& grid, std::vector<double> errors, double size)
    : dt(grid.dt()), values(std::move(errors)) {
  for (const int n : grid.steps) {
    floors.push_back(size * relative_floor(n));
    most_rounding.push_back(std::max(floors.back(), size * 8 * std::numeric_limits<double>::epsilon() * n));
  }
}

std::size_t floored_errors::reaches_floor() const {
  std::size_t i = 0;
  while (i < values.size() && values[i] <= floors[i]) ++i;  // a single step has no residual
  while (i < values.size() && !(values[i] <= floors[i])) ++i;
  return i;
}

std::optional<order_fit> floored_errors::fit() const {
  auto above = values;
  for (std::size_t i = 0; i < above.size(); ++i)
    if (above[i] <= 4 * floors[i] || i > reaches_floor()) above[i] = 0;
  return fit_order(dt, above, 0);
}

/// The series with its fit, and the verdict on its order, which is at least `expected`. Where too few levels are above
/// the floor for a fit: errors at the floor throughout are exactness on this scene; else the fall from the coarsest
/// level to another bounds the order from below.
void report_order(const quantity& what, const std::string& claim, const floored_errors& e, double expected,
                  recorder& record) {
  const auto fit = e.fit();
  curve errors{what};
  for (std::size_t i = 0; i < e.dt.size(); ++i) errors.add(e.dt[i], e.values[i]);
  const auto written = record.series(errors, fit);
  auto v = judge_order(expected, fit, true);
  if (!fit) judge_at_floor(e, expected, v);
  record.verdict(claim, v, {written});
}

constexpr double no_rise = 1e-13;  // of the energy's size: what counts as no rise

struct trajectory {
  std::vector<double> energy, rate;  // at every step, and -dh/dt there
  std::vector<double> end;
};

trajectory follow(const subject& s, const scheme_entry& scheme, double horizon, int steps) {
  const auto& m = *s.model;
  const double dt = horizon / steps;
  const auto stepper = scheme.make(dt);
  const auto view = silence(1);
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

/// Counts the steps in which the energy rises by more than rounding.
report::verdict judge_monotony(std::span<const double> energy, double dt, double tolerance) {
  int rises = 0;
  for (std::size_t k = 1; k < energy.size(); ++k)
    if (!(energy[k] <= energy[k - 1] + tolerance)) ++rises;
  const double count = rises;
  return {.expected = 0.0,
          .estimate = count,
          .low = count,
          .high = count,
          .kind = rises == 0 ? report::verdict_kind::holds : report::verdict_kind::refuted,
          .reason = fmt::format("{} rises in {} steps of {:.3g}", rises, energy.size() - 1, dt)};
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

/// By width alone: a slope that is asymptotic and known well enough, or none to be had by halving on.
bool order_is_resolved(const floored_errors& e) {
  const auto fit = e.fit();
  return !fit || e.reaches_floor() < e.values.size() || (fit->asymptotic && half_width(*fit) <= tight_order);
}

}  // namespace

void report_convergence(const subject& s, const scheme_entry& scheme, const level_grid& first, const true_end& truth,
                        recorder& record) {
  constexpr int most_steps = 1 << 17;
  const double order = scheme.info.deterministic_order;
  const double energy = energy_size(s);
  runs_of_levels runs{{first.horizon, {}}, {}, {}, {}};
  const auto path = [&] { return floored_errors(runs.grid, runs.state_error, length(truth.momentum)); };
  const auto law = [&] { return floored_errors(runs.grid, runs.residual, energy); };
  for (const int n : first.steps) runs.add(s, scheme, n, truth.momentum);
  while (runs.grid.steps.back() <= most_steps / 2 && !(order_is_resolved(path()) && order_is_resolved(law())))
    runs.add(s, scheme, 2 * runs.grid.steps.back(), truth.momentum);
  report_order({truth.prefix + "state_error", "state", "|mu|", truth.method},
               truth.prefix.empty() ? "order of the path" : "order of the free path", path(), order, record);
  report_order({truth.prefix + "law_residual", "energy", "energy", "deterministic"},
               truth.prefix.empty() ? "order of the energy law" : "order of the free energy", law(), order, record);
  if (dissipation_of(s.scene) > 0)
    record.verdict("energy never rises at the finest dt",
                   judge_monotony(runs.finest.energy, runs.grid.dt().back(), no_rise * energy));
}

}  // namespace polhode
