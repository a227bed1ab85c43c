#include "run/choose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>

#include <cmath>

#include "problem/observables.hpp"
#include "reports/model/errors.hpp"
#include "run/bind_scene.hpp"
#include "run/machine_options.hpp"
#include "scene/nearest.hpp"
#include "systems/systems.hpp"

namespace polhode {

selection select(const scene& s, const select_options& o) {
  static const std::vector<std::string> goals{"strong", "weak", "stationary", "energy"};
  gsl_set_error_handler_off();
  apply_isa(o.isa);
  if (o.goal.empty()) throw input_error(fmt::format("--goal is missing; accepted: {}", fmt::join(goals, ", ")));
  choose("--goal", o.goal, goals);
  std::vector<std::string> observables{std::string(all_observables)};
  for (const auto& entry : find_system(s.system)->observables) observables.push_back(entry.name);
  if (o.time && !(*o.time > 0 && std::isfinite(*o.time)))
    throw input_error(fmt::format("--time '{:g}': accepted: a number above 0", *o.time));
  const auto bound = bind_scene(s);
  if (bound.sphere() || !observable_of(bound, o.observable)) choose("--observable", o.observable, observables);
  return select({bound, effort::standard, o.threads, o.seed},
                {o.goal, o.observable, o.time.value_or(s.horizon), o.tolerance}, o.require);
}

}  // namespace polhode
