// SPDX-License-Identifier: Apache-2.0
#include "selection/requirements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "reports/model/errors.hpp"
#include "selection/select.hpp"

namespace polhode {

const std::vector<std::string>& requirements() {
  static const std::vector<std::string> all{"casimir-exact", "explicit", "implicit", "no-areas", "monotone-energy"};
  return all;
}

void check_requirements(const std::vector<std::string>& wanted, const std::vector<candidate>& all) {
  const auto has = [&](const char* name) { return std::ranges::find(wanted, name) != wanted.end(); };
  for (const auto& name : wanted)
    if (std::ranges::find(requirements(), name) == requirements().end())
      throw input_error(fmt::format("--require '{}': not known; accepted: {}", name, fmt::join(requirements(), ", ")));
  if (has("explicit") && has("implicit"))
    throw input_error("--require 'explicit,implicit': contradictory; accepted: one of the two");
  if (std::ranges::all_of(all, [&](const candidate& c) { return lacks(c, wanted).has_value(); }))
    throw input_error(
        fmt::format("--require '{}': no scheme has all of these; see polhode list schemes", fmt::join(wanted, ",")));
}

std::optional<std::string> lacks(const candidate& c, const std::vector<std::string>& wanted) {
  for (const auto& name : wanted) {
    if (name == "casimir-exact" && !c.scheme.info.casimir.exact) return "does not keep the Casimir (required)";
    if (name == "explicit" && c.scheme.info.implicit) return "implicit (explicit is required)";
    if (name == "implicit" && !c.scheme.info.implicit) return "explicit (implicit is required)";
    if (name == "no-areas" && c.scheme.needs_areas) return "needs Levy areas (no areas is required)";
  }
  return std::nullopt;
}

bool monotone_energy(const subject& s, const candidate& c, double dt) {
  constexpr int steps = 4096;
  constexpr double rounding = 1e-14;
  const auto still = s.without_noise();
  const auto stepper = c.scheme.make(dt);
  auto states = replicated(still.scene.momentum);
  double before = still.model->energy(still.scene.momentum);
  for (int i = 0; i < steps; ++i) {
    stepper->advance(states, silence(1));
    const double h = still.model->energy(lane_of(states, 0, still.model->dimension()));
    if (!(h <= before + rounding * std::fabs(before))) return false;
    before = h;
  }
  return true;
}

}  // namespace polhode
