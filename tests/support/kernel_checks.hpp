// SPDX-License-Identifier: Apache-2.0
// What a kernel must do, as distances from it: conformance/ holds every kernel to them, and mutants/ sees by them the
// defects that no verdict tells.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "ensemble/uniform_start.hpp"
#include "run/verify.hpp"
#include "support/kernel_cases.hpp"
#include "support/schemes.hpp"
#include "systems/rigid_body/rigid_body.hpp"
#include "systems/rigid_body/rigid_body_choice.hpp"

namespace polhode::test {

inline vec<double, 3> state_at(std::span<const double> states, int lane) {
  const auto k = [&](int i) { return states[static_cast<std::size_t>(i * block_lanes + lane)]; };
  return {{k(0), k(1), k(2)}};
}

/// Of a step from places all over the unit sphere to the scalar step, the largest.
template <class Scheme>
double distance_from_the_step(const kernel& k, const report::scene& scene) {
  const increments w(*bind_scene(scene).model, 1, k.dt());
  const auto system = prepared<Scheme>(make_rigid_body(scene), k.dt());
  std::vector<double> states(3 * block_lanes);
  start_uniformly(1, 0, 1, states);
  auto after = states;
  k.advance(after, w.view);
  double largest = 0;
  for (int lane = 0; lane < block_lanes; ++lane)
    largest =
        std::max(largest, distance(Scheme::step(system, state_at(states, lane), w.at(0, lane)), state_at(after, lane)));
  return largest;
}

/// Of a path under a common noise to the path that made it, after two hundred steps.
inline double distance_of_common_noise(const kernel& k, const report::scene& scene) {
  constexpr int steps = 200;
  const increments w(*bind_scene(scene).model, steps, k.dt());
  std::vector<double> dw, area;
  for (std::size_t row = 0; row < w.dw.size() / block_lanes; ++row) {
    dw.push_back(w.dw[row * block_lanes]);
    area.push_back(w.area[row * block_lanes]);
  }
  auto own = replicated(scene.momentum), common = own;
  k.advance(own, w.view);
  k.advance(common, k.share({steps, dw, area}), 0, steps);
  return distance(state_at(own, 0), state_at(common, 5));
}

/// Of a look at the states between two pieces to the run that ends there, in lane 0.
inline double distance_of_a_look(const kernel& k, const report::scene& scene) {
  const increments w(*bind_scene(scene).model, 10, k.dt());
  auto stopped = replicated(scene.momentum), seen = stopped;
  k.advance(stopped, w.view);
  for (int i = 0; i < 10; ++i) k.advance(seen, w.step(i), {i == 0, false});
  k.finish(seen);
  return distance(state_at(stopped, 0), state_at(seen, 0));
}

/// With as much dissipation as the polynomials of a size allow at this step.
template <rotation_size size>
report::scene at_the_end_of_polynomials(double dt) {
  return with_parts({1, 2, 3}, (1 - 1e-9) * std::log1p(rotations<size>::bounds.spread) / (2 * (1 - 1.0 / 3) * dt),
                    isotropic);
}

}  // namespace polhode::test
