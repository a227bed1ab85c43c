// SPDX-License-Identifier: Apache-2.0
#include "foreign/foreign_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "foreign/foreign_kernel.hpp"
#include "foreign/probe.hpp"
#include "reports/model/errors.hpp"

namespace polhode::foreign {
namespace {

double order(double claimed) { return claimed > 0 ? claimed : std::numeric_limits<double>::quiet_NaN(); }

/// Whether a short run leaves every Casimir at rounding: what an integrator that claims nothing of them is taken for.
bool seems_to_keep_casimirs(const subject& s, const scheme_entry& e) {
  constexpr int steps = 16;
  const double dt = s.scene.horizon / static_cast<double>(s.scene.steps.back());
  auto states = replicated(s.scene.momentum);
  const auto layout = s.model->layout();
  std::vector<double> dw(layout.increments(steps, block_lanes)), area(layout.areas(steps, block_lanes));
  for (std::size_t i = 0; i < dw.size(); ++i) dw[i] = std::sqrt(dt) * std::sin(1.0 + 2.0 * static_cast<double>(i));
  e.make(dt)->advance(states, layout.silent() ? silence(steps) : increment_view{steps, dw, area});
  const auto first = s.model->casimirs(s.scene.momentum);
  std::vector<double> energies(block_lanes), last(first.size() * block_lanes);
  s.model->conserved(states, energies, last);
  const auto sizes = s.model->casimir_sizes(s.scene.momentum);
  for (std::size_t i = 0; i < last.size(); ++i) {
    const auto k = i / block_lanes;
    if (!(std::fabs(last[i] - first[k]) <= 256 * std::numeric_limits<double>::epsilon() * sizes[k])) return false;
  }
  return true;
}

scheme_entry entry_on(const std::shared_ptr<foreign_scheme>& scheme, const subject& s) {
  const problem p{s.scene, s.model->dimension(), s.model->layout().channels};
  const auto on_steps_of = [p](double dt) {
    auto at = p;
    at.dt = dt;
    return at;
  };
  scheme_entry e{scheme->info(), scheme->about().takes == noise_access::areas,
                 [scheme, on_steps_of](double dt) { return make_kernel(scheme, on_steps_of(dt)); },
                 [scheme, on_steps_of](double dt) { return make_tangent_kernel(scheme, on_steps_of(dt)); }};
  if (scheme->about().claims.casimir == 0 && seems_to_keep_casimirs(s, e)) e.info.casimir = keeps_casimirs;
  return e;
}

}  // namespace

foreign_scheme::foreign_scheme(std::unique_ptr<integrator> i)
    : integrator_(std::move(i)), about_(integrator_->about()), given_(about_.claims) {}

scheme_info foreign_scheme::info() const {
  const auto& c = about_.claims;
  return {
      .name = about_.name,
      .title = about_.title,
      .source = about_.source,
      .calculus = about_.calculus,
      .strong_order = {order(c.strong_commuting), order(c.strong_general)},
      .weak_order = {order(c.weak_one_vector), order(c.weak_isotropic), order(c.weak_general)},
      .deterministic_order = static_cast<int>(c.deterministic),
      .casimir = c.casimir == kept ? keeps_casimirs : casimirs_drift(order(c.casimir), order(c.casimir_deterministic)),
      .implicit = about_.implicit,
      .poisson = about_.poisson};
}

void foreign_scheme::try_on(const subject& s) {
  failure_.reset();
  refusal_.clear();
  const problem p{s.scene, s.model->dimension(), s.model->layout().channels,
                  s.scene.horizon / static_cast<double>(s.scene.steps.back())};
  try {
    const auto found = probe(*integrator_, p);
    if (!found.repeats) return fail("the same step from the same state under the same noise has another result");
    if (!found.two_at_a_time && !about_.one_thread) {
      about_.one_thread = true;
      about_.from += ", on one thread as two interfere";
    }
    cost_ = cost_of_step(*integrator_, p);
  } catch (const foreign::refusal& r) {
    refusal_ = r.what();
  } catch (const foreign::failure& f) {
    fail(f.what());
  }
}

std::vector<std::pair<std::string, double>> foreign_scheme::measured() const {
  std::vector<std::pair<std::string, double>> out;
  for (const auto& [name, order] : named_orders)
    if (given_.*order == 0 && about_.claims.*order != 0) out.emplace_back(name, about_.claims.*order);
  return out;
}

std::optional<std::string> foreign_scheme::failure() const {
  const std::lock_guard lock(guard_);
  return failure_;
}

void foreign_scheme::fail(const std::string& why) {
  const std::lock_guard lock(guard_);
  if (!failure_) failure_ = why;
}

std::unique_lock<std::mutex> foreign_scheme::turn() {
  return about_.one_thread ? std::unique_lock(turn_) : std::unique_lock<std::mutex>();
}

subject with_foreign(subject s, const foreign_schemes& all) {
  if (all.empty()) return s;
  for (const auto& scheme : all) {
    const auto& name = scheme->about().name;
    if (!scheme->refusal().empty()) {
      s.inapplicable.push_back({"", name, scheme->refusal()});
      continue;
    }
    const auto taken = [&](const scheme_entry& e) { return e.info.name == name; };
    if (std::ranges::any_of(s.schemes, taken))
      throw input_error(fmt::format("{}: its name '{}' is that of another scheme; accepted: a name of its own",
                                    scheme->about().from, name));
    s.schemes.push_back(entry_on(scheme, s));
  }
  s.with = [all, with = s.with](const report::scene& other) { return with_foreign(with(other), all); };
  return s;
}

foreign_scheme* find_foreign(const foreign_schemes& all, std::string_view name) {
  const auto found = std::ranges::find_if(all, [&](const auto& one) { return one->about().name == name; });
  return found == all.end() ? nullptr : found->get();
}

}  // namespace polhode::foreign
