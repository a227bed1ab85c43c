// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/rounding_floor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"
#include "statistics/rounding_noise.hpp"

namespace polhode {
namespace {

constexpr int steps = 16, values = noise_difference + 1;
constexpr double spacing = 0x1p-10;  // in phase, over all steps: its sixth power is below rounding
constexpr double component_shift =
    0x1p-17;  // of a component, over |mu|: rounding and the third derivative weigh the same

std::vector<double> energies_of(const model& m, std::span<const double> states) {
  std::vector<double> one(states.size() / block_lanes), energies(block_lanes);
  for (std::size_t k = 0; k < one.size(); ++k) one[k] = states[k * block_lanes];
  std::vector<double> casimirs(m.casimirs(one).size() * block_lanes);
  m.conserved(states, energies, casimirs);
  return energies;
}

}  // namespace

double energy_condition(const model& m, std::span<const double> states) {
  std::vector<double> moved(states.begin(), states.end()), squares(block_lanes), slopes(block_lanes);
  for (std::size_t at = 0; at < states.size(); ++at) squares[at % block_lanes] += states[at] * states[at];
  for (std::size_t row = 0; row < states.size(); row += block_lanes) {
    const auto energies_at = [&](double sign) {
      for (std::size_t lane = 0; lane < block_lanes; ++lane)
        moved[row + lane] = states[row + lane] + sign * component_shift * std::sqrt(squares[lane]);
      return energies_of(m, moved);
    };
    const auto above = energies_at(1), below = energies_at(-1);
    std::ranges::copy(states.subspan(row, block_lanes), moved.begin() + static_cast<std::ptrdiff_t>(row));
    for (std::size_t lane = 0; lane < block_lanes; ++lane)
      slopes[lane] += std::pow((above[lane] - below[lane]) / (2 * component_shift), 2);
  }
  const double sum = std::accumulate(slopes.begin(), slopes.end(), 0.0);
  return std::sqrt(sum / static_cast<double>(states.size()));
}

double condition_on_the_way(const model& m, const kernel& scheme, std::vector<double> states,
                            const increment_view& noise) {
  double squares = 0;
  for (int i = 0; i < noise.steps; ++i) {
    scheme.advance(states, noise.part(i, 1));
    const double here = energy_condition(m, states);
    squares += here * here;
  }
  return std::sqrt(squares / noise.steps);
}

rounding_floor rounding_floor_of(const context& c, const subject& s, const scheme_entry& scheme) {
  const auto& m = *s.model;
  const double dt = finest_step(s);
  increment_buffer noise(m, steps, scheme.needs_areas, {c.generator, noise_quality::precise});
  const auto view = !m.layout().silent() ? noise.fill(c.seed, 0, 0, steps, dt) : silence(steps);
  const auto start = replicated(s.scene.momentum);
  const double apart = spacing / std::max(1e-3, steps * dt * fastest_rate(s));
  std::array<std::vector<double>, values> states, energies;
  for (std::size_t i = 0; i < values; ++i) {
    states[i] = start;
    scheme.make(dt * (1 + apart * static_cast<double>(i)))->advance(states[i], view);
    energies[i] = energies_of(m, states[i]);
  }
  const auto noise_of = [](const auto& found, std::size_t at) {
    std::array<double, values> x{};
    for (std::size_t i = 0; i < values; ++i) x[i] = found[i][at];
    return squared_rounding_noise(x) / block_lanes;
  };
  double state = 0, energy = 0;
  for (std::size_t at = 0; at < start.size(); ++at) state += noise_of(states, at);
  for (std::size_t lane = 0; lane < block_lanes; ++lane) energy += noise_of(energies, lane);
  const double unit = std::numeric_limits<double>::epsilon() * std::sqrt(steps);
  const double condition = condition_on_the_way(m, *scheme.make(dt), start, view);
  const double units = std::sqrt(energy) / (unit * std::max(energy_size(s), condition));
  return {std::sqrt(state) / (unit * length(s.scene.momentum)),
          std::isfinite(condition) ? units : std::numeric_limits<double>::quiet_NaN()};
}

void report_floor(const std::string& claim, double units, recorder& record) {
  if (!std::isfinite(units)) return record.verdict(claim, {.reason = "a path was lost: not finite"});  // inconclusive
  const auto rounding = record.value({"rounding", "", "2^-52", "deterministic"}, units);
  record.verdict(claim,
                 judge_distance({units, units, units}, floor_bound,
                                fmt::format("rounding of {:.2g} x 2^-52 a root of the number of steps, bound {:g}",
                                            units, floor_bound)),
                 {rounding});
}

}  // namespace polhode
