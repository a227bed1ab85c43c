#include "registry/rigid_body_choice.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {

rotation_size rotation_size_of(const rigid_body& body, double radius, double dt) {
  const auto& inverse = body.inverse_inertia;
  const double most = std::max({inverse[0], inverse[1], inverse[2]}),
               least = std::min({inverse[0], inverse[1], inverse[2]}), c = radius,
               noise = (body.sigma() * body.sigma().transpose()).operatorNorm();
  const double drift = dt * c * (most + 0.5 * body.theta * c * (most - least));
  // The longest turns: of the free motion in five, and of the two after the Casimir shift, the first merged.
  const double turn = std::max({inverse[0] / 2, inverse[1] / 2, inverse[2], std::abs(inverse[0] - inverse[1]),
                                std::abs(inverse[2] - inverse[1]) / 2});
  const rotation_bounds needed{dt * c * turn, drift + 4.5 * std::sqrt(dt * noise),
                               std::expm1(2 * body.theta * c * c * (most - least) * dt)};
  const auto within = [&](const rotation_bounds& b) {
    return needed.turn <= b.turn && needed.generator <= b.generator && needed.spread <= b.spread;
  };
  return within(rotations<rotation_size::small>::bounds)      ? rotation_size::small
         : within(rotations<rotation_size::moderate>::bounds) ? rotation_size::moderate
                                                              : rotation_size::any;
}

int first_axis_of(const rigid_body& body) { return body.odd_axis() < 0 ? 0 : (body.odd_axis() + 1) % 3; }

body_parts parts_of(const rigid_body& body) {
  const auto& i = body.inverse_inertia;
  const bool spherical = i[0] == i[1] && i[1] == i[2];
  return {body.odd_axis() < 0, !spherical, body.theta > 0 && !spherical};
}

}  // namespace polhode
