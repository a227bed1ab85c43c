// SPDX-License-Identifier: Apache-2.0
#include "systems/rigid_body/rigid_body_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace polhode {
namespace {

/// |1/I_k - 1/I_2| of the two turns after the Casimir shift, over the part of the step that each takes: the first is
/// merged with the one before, the last takes half. A symmetric body has the first alone.
std::array<double, 2> shifted_turns(const rigid_body& body) {
  const auto& inverse = body.inverse_inertia;
  const double first = std::abs(inverse[0] - inverse[1]), last = std::abs(inverse[2] - inverse[1]);
  if (body.odd_axis() < 0) return {first, last / 2};
  return {std::max(first, last), 0};
}

}  // namespace

rotation_size rotation_size_of(const rigid_body& body, double radius, double dt) {
  const auto& inverse = body.inverse_inertia;
  const double most = std::max({inverse[0], inverse[1], inverse[2]}),
               least = std::min({inverse[0], inverse[1], inverse[2]}), c = radius,
               noise = (body.sigma() * body.sigma().transpose()).operatorNorm();
  const double drift = dt * c * (most + 0.5 * body.theta * c * (most - least));
  const auto [first, last] = shifted_turns(body);
  const double turn = std::max({inverse[0] / 2, inverse[1] / 2, inverse[2], first});
  const rotation_bounds needed{dt * c * turn, dt * c * last, drift + 4.5 * std::sqrt(dt * noise),
                               std::expm1(2 * body.theta * c * c * (most - least) * dt)};
  const auto within = [&](const rotation_bounds& b) {
    return needed.turn <= b.turn && needed.half_turn <= b.half_turn && needed.generator <= b.generator &&
           needed.spread <= b.spread;
  };
  constexpr double far = 1e50;  // shears take powers of |Pi| and of angles over it
  if (c > 1 / far && c < far && within(rotations<rotation_size::tiny>::bounds)) return rotation_size::tiny;
  return within(rotations<rotation_size::small>::bounds)      ? rotation_size::small
         : within(rotations<rotation_size::moderate>::bounds) ? rotation_size::moderate
                                                              : rotation_size::any;
}

int first_axis_of(const rigid_body& body) { return body.odd_axis() < 0 ? 0 : (body.odd_axis() + 1) % 3; }

body_parts parts_of(const rigid_body& body) {
  const auto& i = body.inverse_inertia;
  const bool spherical = i[0] == i[1] && i[1] == i[2];
  return {!spherical, body.odd_axis() < 0, body.theta > 0 && !spherical};
}

}  // namespace polhode
