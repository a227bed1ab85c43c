// SPDX-License-Identifier: Apache-2.0
#include "run/measured_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "run/bind_scene.hpp"
#include "run/run_experiment.hpp"

namespace polhode {
namespace {

using foreign::claims;

/// An order, where a first run finds it, and what is tried on the way.
struct order_claim {
  std::string_view experiment, quantity, observable;
  double claims::*order;
  double trial, step;  ///< orders are multiples of it
};

/// Of a scene with that noise: what it can tell.
std::vector<order_claim> orders_told_by(noise_class noise) {
  std::vector<order_claim> all{{"energy", "state_error", "state", &claims::deterministic, 1, 1}};
  all.push_back({"casimir", "drift", "casimir",
                 noise == noise_class::none ? &claims::casimir_deterministic : &claims::casimir, 1, 0.5});
  if (noise == noise_class::none) return all;
  if (noise == noise_class::one_vector) {
    all.push_back({"strong", "error", "state", &claims::strong_commuting, 1, 0.5});
    all.push_back({"weak", "error", "", &claims::weak_one_vector, 1, 1});
    return all;
  }
  all.push_back({"strong", "error", "state", &claims::strong_general, 0.5, 0.5});
  all.push_back(
      {"weak", "error", "", noise == noise_class::isotropic ? &claims::weak_isotropic : &claims::weak_general, 1, 1});
  return all;
}

/// Whether one of the experiments (none: all are asked) judges by the order that `measured_in` finds. The energy's is
/// that of the Poisson defect, too; all that follows from one step's law has the weak order.
bool rests_on(const std::vector<std::string>& experiments, std::string_view measured_in) {
  return experiments.empty() || std::ranges::any_of(experiments, [&](const std::string& e) {
           if (measured_in == "strong" || measured_in == "casimir") return e == measured_in;
           if (measured_in == "energy") return e == "energy" || e == "casimir" || e == "modified";
           return e != "strong" && e != "casimir";
         });
}

/// The claim that a verdict on an order rests on, on a scene with that noise.
double claims::*order_behind(const report::verdict& v, noise_class noise) {
  const bool commutes = noise == noise_class::one_vector, none = noise == noise_class::none;
  if (v.experiment == "strong") return commutes ? &claims::strong_commuting : &claims::strong_general;
  if (v.experiment == "casimir" && v.claim.find("Poisson") == std::string::npos)
    return none ? &claims::casimir_deterministic : &claims::casimir;
  if (v.experiment == "energy" || v.experiment == "casimir" || none) return &claims::deterministic;
  return commutes                          ? &claims::weak_one_vector
         : noise == noise_class::isotropic ? &claims::weak_isotropic
                                           : &claims::weak_general;
}

experiment named(std::string_view name) {
  if (name == "energy") return energy_experiment();
  if (name == "casimir") return casimir_experiment();
  return name == "strong" ? strong_experiment() : weak_experiment();
}

/// The lowest order among the fits of that quantity, a multiple of `step`.
std::optional<double> order_in(const report::results& r, const order_claim& c) {
  std::optional<double> lowest;
  for (const auto& f : r.fits)
    if (f.experiment == c.experiment && f.quantity == c.quantity &&
        (c.observable.empty() || f.observable == c.observable) && f.over == report::step_size)
      lowest = std::min(lowest.value_or(f.order), f.order);
  if (!lowest || !(*lowest > 0)) return {};
  return std::max(c.step, c.step * std::round(*lowest / c.step));
}

}  // namespace

void measure_claims(const scene& s, const std::shared_ptr<foreign::foreign_scheme>& scheme,
                    const std::vector<std::string>& experiments, int threads, std::uint64_t seed) {
  scheme->try_on(bind_scene(s));
  if (scheme->failure() || !scheme->refusal().empty()) return;
  const auto given = scheme->given();
  scheme->take_as_claimed(given);
  const bool draws = scheme->about().takes == foreign::noise_access::own_numbers;
  auto subject = restricted(bind_scene(s, {scheme}), {scheme->about().name});
  const bool keeps = subject.schemes.front().info.casimir.exact;
  std::vector<order_claim> open;
  auto trial = given;
  for (const auto& c : orders_told_by(subject.model->noise())) {
    const bool tells = c.experiment != "casimir" || !keeps;
    if (given.*c.order != 0 || !tells || !rests_on(experiments, c.experiment) || (draws && c.experiment != "energy"))
      continue;
    open.push_back(c);
    trial.*c.order = c.trial;
  }
  if (keeps && given.casimir == 0) trial.casimir = foreign::kept;
  auto measured = given;
  measured.casimir = trial.casimir == foreign::kept ? foreign::kept : given.casimir;
  if (!open.empty()) {
    scheme->take_as_claimed(trial);
    subject = restricted(bind_scene(s, {scheme}), {scheme->about().name});
    for (const auto& c : open) {
      const auto e = named(c.experiment);
      if (e.skip_reason(subject)) continue;
      report::results found;
      e.run({subject, effort::quick, threads, seed + 1}, found);
      measured.*c.order = order_in(found, c).value_or(0);
    }
  }
  scheme->take_as_claimed(measured);
}

void excuse_unclaimed(const foreign::foreign_schemes& all, noise_class noise, report::results& out) {
  using report::verdict_kind;
  for (const auto& scheme : all)
    for (auto& v : out.verdicts) {
      const bool open = v.kind == verdict_kind::refuted || v.kind == verdict_kind::inconclusive;
      if (!open || v.scheme != scheme->about().name || v.claim.find("order") == std::string::npos) continue;
      if (scheme->given().*order_behind(v, noise) != 0 || v.reason.starts_with("wrong limit")) continue;
      v.kind = verdict_kind::skipped;
      v.reason = "not claimed; measured: " + v.reason;
      v.expected.reset();
    }
}

}  // namespace polhode
