// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/modified_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr int steps = 7, first_piece = 3;
constexpr double allowed = 1e-12;  // of the momentum: rounding of so few steps

using block_states = std::vector<double>;

/// The ways to take `steps` steps: a step at a time first.
std::vector<block_states> own_noise(const kernel& k, const block_states& start, const increment_view& noise) {
  block_states single = start, whole = start, pieces = start;
  for (int i = 0; i < steps; ++i) k.advance(single, noise.part(i, 1));
  k.advance(whole, noise);
  k.advance(pieces, noise.part(0, first_piece), {true, false});
  k.advance(pieces, noise.part(first_piece, steps - first_piece), {false, true});
  return {single, whole, pieces};
}

std::vector<block_states> common_noise(const kernel& k, const block_states& start, const increment_view& one_path) {
  const auto table = k.share(one_path);
  block_states single = start, whole = start, pieces = start;
  for (int i = 0; i < steps; ++i) k.advance(single, table, i, 1);
  k.advance(whole, table, 0, steps);
  k.advance(pieces, table, 0, first_piece, {true, false});
  k.advance(pieces, table, first_piece, steps - first_piece, {false, true});
  return {single, whole, pieces};
}

double largest_difference(const std::vector<block_states>& ways) {
  double largest = 0;
  for (const auto& other : ways)
    for (std::size_t i = 0; i < other.size(); ++i) {
      const double d = std::fabs(other[i] - ways.front()[i]);
      largest = std::isnan(d) ? std::numeric_limits<double>::infinity() : std::max(largest, d);
    }
  return largest;
}

/// Of lane 0 alone: [step][channel].
std::vector<double> one_lane(std::span<const double> block) {
  std::vector<double> out;
  for (std::size_t i = 0; i < block.size(); i += block_lanes) out.push_back(block[i]);
  return out;
}

}  // namespace

report::verdict judge_steps(const context& c, const scheme_entry& scheme) {
  const auto& s = c.subject;
  const double dt = 1 / (16 * std::max(fastest_rate(s), 1e-300)), size = length(s.scene.momentum);
  const auto k = scheme.make(dt);
  const auto start = replicated(s.scene.momentum);
  increment_buffer buffer(*s.model, steps, scheme.needs_areas, {c.generator, noise_quality::precise});
  const auto noise = !s.model->layout().silent() ? buffer.fill(c.seed, 0, 0, steps, dt) : silence(steps);
  double worst = 0;
  if (!noise.silent()) {
    const auto dw = one_lane(noise.dw), area = one_lane(noise.area);
    worst = std::max(largest_difference(own_noise(*k, start, noise)),
                     largest_difference(common_noise(*k, start, {steps, dw, area})));
  } else {
    worst = largest_difference(own_noise(*k, start, noise));
  }
  return judge_distance(
      {worst / size, worst / size, worst / size}, allowed,
      fmt::format("{} steps in one call, in pieces of {} and {}, and one at a time: momenta differ by {:.1e} "
                  "of their size, allowed {:.0e}",
                  steps, first_piece, steps - first_piece, worst / size, allowed));
}

}  // namespace polhode
