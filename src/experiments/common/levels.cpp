// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problem/vectors.hpp"
#include "statistics/orders/level_choice.hpp"

namespace polhode {
namespace {

constexpr double time_scales = 4;

}  // namespace

double fastest_rate(const subject& s) { return s.offers->rates.fastest(); }

double energy_size(const subject& s) {
  constexpr double next_to_zero = 0.01;
  const double own = std::fabs(s.model->energy(s.scene.momentum));
  const double moved = length(s.scene.momentum) * s.offers->rates.motion;
  return std::max(own < next_to_zero * moved ? moved : own, 1e-300);
}

double finest_step(const subject& s) {
  const double own = s.scene.horizon / static_cast<double>(s.scene.steps.back()), rate = fastest_rate(s);
  return rate > 0 ? std::min(own, 1 / (time_scales * rate)) : own;
}

double longest_at_equilibrium(const subject& s) { return time_scales / fastest_rate(s); }

level_grid asymptotic_levels(const subject& s, double resolution) {
  const double rate = fastest_rate(s);
  level_grid grid{rate > 0 ? std::min(s.scene.horizon, time_scales / rate) : s.scene.horizon, {}};
  const double needed = resolution * rate * grid.horizon;
  // Start from the scene's coarsest step where that leaves room for a fit; else from a power of two.
  const double own = static_cast<double>(s.scene.steps.front()) * grid.horizon / s.scene.horizon;
  const int enough = 1 << (fitted_levels - 1);
  int n = own <= needed / enough ? std::max(1, static_cast<int>(std::lround(own))) : 1;
  while (n * enough < needed && own > needed / enough) n *= 2;
  for (; grid.steps.empty() || grid.steps.back() < needed || static_cast<int>(grid.steps.size()) < fitted_levels;
       n *= 2)
    grid.steps.push_back(n);
  return grid;
}

std::optional<std::string> beyond_reach(const subject& s) {
  const double scales = fastest_rate(s) * s.scene.horizon;
  if (scales <= most_time_scales) return std::nullopt;
  return fmt::format("horizon = {} is {:.2g} of the fastest time scales: runs over more than {:g} are out of reach",
                     s.scene.horizon, scales, most_time_scales);
}

level_grid scene_levels(const subject& s) {
  constexpr double resolution = 64;
  constexpr std::size_t fewest_levels = 5;
  level_grid grid{beyond_reach(s) ? most_time_scales / fastest_rate(s) : s.scene.horizon,
                  {s.scene.steps.begin(), s.scene.steps.end()}};
  const double scales = fastest_rate(s) * grid.horizon;
  auto& steps = grid.steps;
  while (steps.size() < fewest_levels && steps.front() % 2 == 0 && steps.front() >= 2 * scales)
    steps.insert(steps.begin(), steps.front() / 2);
  while (steps.size() < fewest_levels || steps.back() < resolution * scales) steps.push_back(2 * steps.back());
  return grid;
}

}  // namespace polhode
