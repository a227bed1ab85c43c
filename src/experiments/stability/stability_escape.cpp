// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_escape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "transfer/basis/radial_motion.hpp"
#include "transfer/points/point_block.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

constexpr int escape_steps = 32, directions = 6;
constexpr double growth = 1e6, farthest = 1e6, accuracy = 1.01;
constexpr double rare = 1e-6;  // of paths, within the horizon
constexpr int most_halvings = 10;
constexpr transfer_rule shell_rule{{16, 7, 5}, {5, 2}};

bool runs_off(const kernel& k, const points_in_space& from) {
  std::vector<double> states(3 * block_lanes);
  for (int first = 0; first < from.rows(); first += block_lanes) {
    load_block(from, first, states.data());
    k.advance(states, silence(escape_steps));
    for (int lane = 0; lane < lanes_in_use(from, first); ++lane) {
      const double* at = states.data() + lane;
      if (!(std::hypot(at[0], at[block_lanes], at[2 * block_lanes]) <= growth * from.row(first).norm())) return true;
    }
  }
  return false;
}

}  // namespace

double escape_radius(const stability_case& in, const scheme_entry& scheme, double dt) {
  const auto k = scheme.make(dt);
  const points_in_space unit = in.casimirs.front() * sphere_quadrature(directions).points;
  double stays = 1, off = 1;
  while (!runs_off(*k, off * unit)) {
    stays = off;
    off *= 2;
    if (off > farthest) return std::numeric_limits<double>::infinity();
  }
  while (off > accuracy * stays) {
    const double middle = std::sqrt(off * stays);
    (runs_off(*k, middle * unit) ? off : stays) = middle;
  }
  return off;
}

void report_escape(const stability_case& in, const scheme_entry& scheme, recorder& record) {
  if (scheme.info.casimir.exact) return;
  const auto row = [&](const char* name, double dt, std::optional<double> value, const char* unit) {
    auto m = row_in(in, {name, "", unit, "exact"}, value);
    m.set_over(at_dt(dt));
    record.row(std::move(m));
  };
  double dt = 1 / in.rate;
  for (int i = 0; i <= most_halvings; ++i, dt /= 2) {
    const auto n = static_cast<std::int64_t>(std::ceil(in.horizon / dt));
    const double radius = escape_radius(in, scheme, dt);
    row("escape_radius", dt, std::isfinite(radius) ? std::optional(radius) : std::nullopt, "|Pi|");
    if (in.bound.model->noise() == noise_class::none) continue;
    const double share = taken_back(in.bound, scheme, dt, n, shell_rule);
    row("share_leaving_shell", dt, std::isfinite(share) ? std::optional(share) : std::nullopt, "paths, at most");
    if (share > rare) continue;
    record.row(row_in(in, {"dt_with_rare_escapes", "", "time", "exact"}, dt));
    return;
  }
}

}  // namespace polhode
