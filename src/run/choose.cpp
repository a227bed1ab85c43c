// SPDX-License-Identifier: Apache-2.0
#include "run/choose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>

#include <cmath>

#include "problem/observables.hpp"
#include "reports/model/errors.hpp"
#include "run/bind_scene.hpp"
#include "run/machine_options.hpp"
#include "run/measured_claims.hpp"
#include "run/run_experiment.hpp"
#include "scene/nearest.hpp"
#include "systems/systems.hpp"

namespace polhode {

namespace {

/// Errors are measured under noise that another run shares.
subject without_own_numbers(const subject& s, const foreign::foreign_schemes& all, std::vector<rejection>& silent) {
  std::vector<std::string> others;
  for (const auto& e : s.schemes) {
    const auto* from = find_foreign(all, e.info.name);
    if (from != nullptr && from->about().takes == foreign::noise_access::own_numbers)
      silent.push_back({std::string(e.info.name), "draws random numbers of its own; accepted: takes increments"});
    else
      others.emplace_back(e.info.name);
  }
  return silent.empty() ? s : restricted(s, others);
}

void tell_failures(const foreign::foreign_schemes& all, selection& found) {
  for (const auto& one : all)
    if (const auto why = one->failure())
      for (auto& r : found.rejected)
        if (r.scheme == one->about().name) r.reason = *why;
}

}  // namespace

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
  for (const auto& one : o.foreign)
    measure_claims(s, one, {o.goal == "stationary" ? "gibbs" : o.goal}, o.threads, o.seed);
  const auto bound = bind_scene(s, o.foreign);
  require_scale(bound);
  if (bound.sphere() || !observable_of(bound, o.observable)) choose("--observable", o.observable, observables);
  std::vector<rejection> silent;
  const auto asked = without_own_numbers(bound, o.foreign, silent);
  auto found = select({asked, effort::standard, o.threads, o.seed},
                      {o.goal, o.observable, o.time.value_or(s.horizon), o.tolerance}, o.require);
  found.rejected.insert(found.rejected.end(), silent.begin(), silent.end());
  tell_failures(o.foreign, found);
  if (found.winner && find_foreign(o.foreign, found.winner->scheme) != nullptr) found.snippet.clear();  // it is theirs
  return found;
}

}  // namespace polhode
