// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_long.hpp"
#include "experiments/common/levels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/stability/stability_run.hpp"
#include "statistics/distributions.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

constexpr int chunk = 1 << 16, part = 256;  // steps between measurements, and of increments in the nearest cache
constexpr double many_steps = 1e9, many_paths = 1e6, affordable = 2e10;

/// A Fibonacci lattice: 64 directions, none of them on an axis.
std::vector<double> spread_over_sphere(double radius) {
  std::vector<double> states(3 * block_lanes);
  for (std::size_t i = 0; i < block_lanes; ++i) {
    const double z = (2 * static_cast<double>(i) + 1) / block_lanes - 1, across = std::sqrt(1 - z * z);
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / std::numbers::phi;
    states[i] = radius * across * std::cos(angle);
    states[block_lanes + i] = radius * across * std::sin(angle);
    states[2 * block_lanes + i] = radius * z;
  }
  return states;
}

std::vector<double> lengths(const model& m, std::span<const double> states) {
  std::vector<double> energy(block_lanes), length(block_lanes);
  m.conserved(states, energy, length);
  return length;
}

double rms_change(std::span<const double> now, std::span<const double> start) {
  double square = 0;
  for (std::size_t i = 0; i < now.size(); ++i) square += std::pow(now[i] / start[i] - 1, 2);
  return std::sqrt(square / static_cast<double>(now.size()));
}

}  // namespace

long_drift drift_over(const subject& s, const scheme_entry& scheme, double dt, double steps, std::uint64_t seed,
                      noise_generator generator, const block_listener& hear) {
  const auto& m = *s.model;
  const auto stepper = scheme.make(dt);
  const auto& pi = s.scene.momentum;
  auto states = spread_over_sphere(std::hypot(pi[0], pi[1], pi[2]));
  const auto start = lengths(m, states);
  const auto chunks = static_cast<std::uint64_t>(steps / chunk);
  const bool silent = m.layout().silent();
  increment_buffer noise(m, silent ? 0 : part, scheme.needs_areas, {generator, noise_quality::fast});
  long_drift out;
  std::uint64_t next = 1;
  for (std::uint64_t i = 0; i < chunks; ++i) {
    for (std::uint64_t k = i * chunk; k < (i + 1) * chunk; k += part) {
      const auto view = silent ? silence(part) : noise.fill(seed, 0, k, part, dt);
      const auto first = static_cast<std::int64_t>(k);
      if (hear && !silent && first < heard_steps) hear(first, view, dt);
      stepper->advance(states, view);
    }
    if (i + 1 < next && i + 1 < chunks) continue;
    out.steps.push_back(static_cast<double>(i + 1) * chunk);
    out.rms.push_back(rms_change(lengths(m, states), start));
    next *= 2;
  }
  return out;
}

void report_long_drift(const context& c, const scheme_entry& scheme, recorder& record, const block_listener& hear) {
  if (!scheme.info.casimir.exact) return;
  const double dt = finest_step(c.subject);
  const auto found =
      drift_over(c.subject, scheme, dt, scheme.info.implicit ? many_steps / 10 : many_steps, c.seed, c.generator, hear);
  curve drift{{"casimir_drift", "casimir", "relative", "sampled"}, report::step_count, "1"};
  drift.at = {at_dt(dt)};
  for (std::size_t i = 0; i < found.steps.size(); ++i) drift.add(found.steps[i], found.rms[i]);
  record.series(drift, fit_power_law(found.steps, found.rms));
}

void report_rare_breaks(const context& c, const stability_case& in, const scheme_entry& scheme,
                        const stability_limit& limit, recorder& record, const block_listener& hear) {
  if (limit.stable == 0 || in.bound.model->noise() == noise_class::none) return;
  const auto steps = 2 * limit.stable;
  const double paths = std::min(many_paths, affordable / static_cast<double>(steps));
  const auto o =
      run_until_broken(in, scheme, {in.dt(steps), steps, static_cast<int>(paths), c.seed, c.generator, true, hear});
  auto m = row_in(in, {"rare_break_share", "", "1", "sampled"}, static_cast<double>(o.broken) / o.paths);
  m.set_over(at_dt(in.dt(steps)));
  const auto share = binomial_bounds(o.paths, o.broken, 0.025);
  m.low = share.low;
  m.high = share.high;
  record.row(std::move(m));
}

}  // namespace polhode
