#include "experiments/common/rounding_floor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"
#include "statistics/rounding_noise.hpp"

namespace polhode {
namespace {

constexpr int steps = 16, values = noise_difference + 1;
constexpr double spacing = 0x1p-10;  // in phase, over all steps: its sixth power is below rounding

}  // namespace

rounding_floor rounding_floor_of(const context& c, const subject& s, const scheme_entry& scheme) {
  const auto& m = *s.model;
  const double dt = s.scene.horizon / static_cast<double>(s.scene.steps.back());
  increment_buffer noise(m, steps, scheme.needs_areas, {c.generator, noise_quality::precise});
  const auto view = !m.layout().silent() ? noise.fill(c.seed, 0, 0, steps, dt) : silence(steps);
  const auto start = replicated(s.scene.momentum);
  const double apart = spacing / std::max(1e-3, steps * dt * fastest_rate(s));
  std::array<std::vector<double>, values> states, energies;
  for (std::size_t i = 0; i < values; ++i) {
    states[i] = start;
    scheme.make(dt * (1 + apart * static_cast<double>(i)))->advance(states[i], view);
    energies[i].resize(block_lanes);
    std::vector<double> casimirs(m.casimirs(s.scene.momentum).size() * block_lanes);
    m.conserved(states[i], energies[i], casimirs);
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
  return {std::sqrt(state) / (unit * length(s.scene.momentum)), std::sqrt(energy) / (unit * energy_size(s))};
}

void report_floor(const std::string& claim, double units, recorder& record) {
  const auto rounding = record.value({"rounding", "", "2^-52", "deterministic"}, units);
  record.verdict(claim,
                 judge_distance({units, units, units}, floor_bound,
                                fmt::format("rounding of {:.2g} x 2^-52 a root of the number of steps, bound {:g}",
                                            units, floor_bound)),
                 {rounding});
}

}  // namespace polhode
