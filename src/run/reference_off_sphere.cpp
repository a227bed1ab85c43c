// SPDX-License-Identifier: Apache-2.0
#include "run/reference_off_sphere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/model/errors.hpp"
#include "scene/nearest.hpp"
#include "sphere/products/pair_expectations.hpp"
#include "systems/systems.hpp"

namespace polhode {

void refuse_observable(const std::string& name, const std::vector<observable_entry>& accepted) {
  std::vector<std::string> known;
  for (const auto& entry : accepted) known.push_back(entry.name);
  refuse("--observable", name, "not known" + accepted_instead(name, known));
}

void refuse_scene(const scene& s, const reference_answer& out, std::string_view why) {
  throw input_error(fmt::format("scene {}: {}: {}", s.name, out.quantity, why));
}

void take(const scene& s, const reference_value& found, reference_answer& out, double scale) {
  if (!found.value) refuse_scene(s, out, found.reason);
  if (!std::isfinite(*found.value)) refuse_scene(s, out, "beyond what double precision holds");
  const double size = std::max(std::fabs(*found.value), scale);
  if (!found.reason.empty() && found.uncertainty > 0.1 * size)
    refuse_scene(
        s, out,
        fmt::format("{:.2g} +- {:.1g} holds no certain digit; {}", *found.value, found.uncertainty, found.reason));
  out.value = *found.value;
  out.uncertainty = found.uncertainty;
  out.degree = found.degree;
  out.reason = found.reason;
}

namespace {

constexpr double pair_tolerance = 1e-7;  // of the size of the observable

/// Where there is no sphere, but a Gibbs law that the system knows.
reference_answer gibbs_answer(const subject& bound, const reference_options& o) {
  const auto& s = bound.scene;
  reference_answer out;
  out.quantity = o.quantity;
  out.observable = o.observable.value_or(usual_observable);
  if (o.degree > 0) refuse("--degree", fmt::format("{}", o.degree), "accepted for systems on a sphere of momentum");
  const auto found = bound.offers->gibbs_mean(out.observable);
  if (!found) refuse_observable(out.observable, find_system(s.system)->observables);
  out.method = "the Gibbs law exp(-2 theta h / sigma^2), in closed form but for one quadrature";
  take(s, *found, out);
  return out;
}

/// On a product of two spheres.
reference_answer pair_answer(const subject& bound, const sphere_pair& pair, const reference_options& o) {
  const auto& s = bound.scene;
  reference_answer out;
  out.quantity = o.quantity;
  out.observable = o.observable.value_or(usual_observable);
  out.time = o.time.value_or(s.horizon);
  if (o.degree != 0 && (o.degree < 2 || o.degree > most_pair_degree))
    refuse("--degree", fmt::format("{}", o.degree),
           fmt::format("accepted for a product of two spheres: 2 to {}", most_pair_degree));
  const auto f = site_observable_named(out.observable, 2);
  if (!f) refuse_observable(out.observable, find_system(s.system)->observables);
  pair_expectations exact(pair, Eigen::Map<const Eigen::Matrix<double, 6, 1>>(s.momentum.data()), *out.time);
  const auto found = exact.of(*f, pair_tolerance, o.degree);
  out.method = pair.has_noise() ? "Kolmogorov's backward equation in products of spherical harmonics"
                                : "no noise: the one path, by Boost.Odeint";
  if (found.relaxed) out.method += ", until only the stationary mean is left";
  take(s, found, out);
  return out;
}

}  // namespace

reference_answer reference_off_sphere(const subject& bound, const reference_options& o) {
  if (o.quantity == "gibbs" && bound.offers->gibbs_mean) return gibbs_answer(bound, o);
  if (o.quantity == "expectation" && bound.offers->pair) return pair_answer(bound, *bound.offers->pair, o);
  const auto& s = bound.scene;
  throw input_error(
      fmt::format("scene {}: system = \"{}\" has no exact references: {}", s.name, s.system, no_exact_law));
}

}  // namespace polhode
