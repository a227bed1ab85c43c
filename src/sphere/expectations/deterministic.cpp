// SPDX-License-Identifier: Apache-2.0
#include "sphere/expectations/deterministic.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "references/free_rotation.hpp"
#include "references/odeint.hpp"

namespace polhode {
namespace {

constexpr double most_turns = 1e7;  // seconds
constexpr double motion_rounding = 1e-14;
constexpr double first_piece = 0.37;  // of the time: no divisor of the solver's first step

using vector = Eigen::Vector3d;

vector solved(const sphere_problem& p, const vector& start, double time) {
  const auto drift = [&](std::span<const double> mu, std::span<double> out) {
    const vector pi(mu[0], mu[1], mu[2]), rate = p.rate(pi);
    Eigen::Map<vector>(out.data()) = pi.cross(rate + p.damping * pi.cross(rate));
  };
  return vector(solve_drift(drift, std::array{start[0], start[1], start[2]}, time).data());
}

vector second_opinion(const sphere_problem& p, const vector& start, double time) {
  if (p.damping == 0 && !p.has_field() && p.quadratic.isDiagonal(0) && p.quadratic.diagonal().minCoeff() > 0) {
    const Eigen::Array3d inertia = p.quadratic.diagonal().array().inverse();
    return vector(free_rotation({inertia[0], inertia[1], inertia[2]}, {start[0], start[1], start[2]}, time).data());
  }
  return solved(p, solved(p, start, first_piece * time), (1 - first_piece) * time);
}

}  // namespace

reference_value on_the_path(const sphere_problem& p, const sphere_function& f, const vector& start, double time) {
  const double turns = time * greatest_rate_on(p) * (1 + p.damping * p.radius);
  if (turns > most_turns)
    return {.reason =
                fmt::format("no noise, and {:.2g} turns are too many to follow; at most {:g}", turns, most_turns)};
  const double value = f(solved(p, start, time));
  if (!std::isfinite(value)) return {.reason = "no noise, and the solver of the path broke down"};
  const double other = f(second_opinion(p, start, time));
  return {.value = value,
          .uncertainty = std::max(std::fabs(value - other), motion_rounding * std::max(1.0, std::fabs(value)))};
}

}  // namespace polhode
