// SPDX-License-Identifier: Apache-2.0
#include "experiments/energy/least_energy_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "sphere/equilibria.hpp"

namespace polhode {
namespace {

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

}  // namespace

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

}  // namespace polhode
