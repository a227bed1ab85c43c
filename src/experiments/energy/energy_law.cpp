// SPDX-License-Identifier: Apache-2.0
#include "experiments/energy/energy_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/energy/floored_errors.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr double rounding = 1e-13;  // of the energy's size: what counts as no rise

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
                   judge_monotony(runs.finest.energy, runs.grid.dt().back(), rounding * energy));
}

}  // namespace polhode
