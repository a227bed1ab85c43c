// SPDX-License-Identifier: Apache-2.0
#include "run/reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "reports/model/errors.hpp"
#include "run/bind_scene.hpp"
#include "scene/nearest.hpp"
#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/galerkin/reference_value.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/harmonics/observables.hpp"
#include "sphere/lyapunov.hpp"
#include "sphere/products/pair_expectations.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "systems/systems.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

constexpr const char* usual_observable = "energy";

[[noreturn]] void refuse_observable(const std::string& name, const std::vector<observable_entry>& accepted) {
  std::vector<std::string> known;
  for (const auto& entry : accepted) known.push_back(entry.name);
  refuse("--observable", name, "not known" + accepted_instead(name, known));
}

[[noreturn]] void refuse_scene(const scene& s, const reference_answer& out, std::string_view why) {
  throw input_error(fmt::format("scene {}: {}: {}", s.name, out.quantity, why));
}

/// scale: the size that the value is measured by, besides its own. Where not one digit is certain, words say more.
void take(const scene& s, const reference_value& found, reference_answer& out, double scale = 0) {
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

// References of systems that live on no sphere of momentum.

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

/// The means of a Gibbs law that the system knows, and expectations on a product of two spheres. Throws input_error for
/// what else is asked.
reference_answer reference_off_sphere(const subject& bound, const reference_options& o) {
  if (o.quantity == "gibbs" && bound.offers->gibbs_mean) return gibbs_answer(bound, o);
  if (o.quantity == "expectation" && bound.offers->pair) return pair_answer(bound, *bound.offers->pair, o);
  const auto& s = bound.scene;
  throw input_error(
      fmt::format("scene {}: system = \"{}\" has no exact references: {}", s.name, s.system, no_exact_law));
}

// Of the size of what is asked for: of the observable, of the noise, of the shear.
constexpr double value_tolerance = 1e-11, rate_tolerance = 1e-9, finest_rate_tolerance = 1e-11,
                 exponent_tolerance = 1e-7;
const std::vector<std::string> quantities{"expectation", "gibbs", "lyapunov", "gap"};

/// An option that would change nothing is a misunderstanding.
void check_that_it_is_used(const reference_options& o) {
  const bool timed = o.quantity == "expectation", observed = timed || o.quantity == "gibbs";
  if (o.time && !timed)
    refuse("--time", fmt::format("{}", *o.time), o.quantity + " has no time; accepted with --quantity expectation");
  if (o.observable && !observed)
    refuse("--observable", *o.observable, o.quantity + " has none; accepted with --quantity expectation or gibbs");
}

void check(const reference_options& o) {
  if (o.quantity.empty())
    throw input_error(fmt::format("--quantity is missing; accepted: {}", fmt::join(quantities, ", ")));
  choose("--quantity", o.quantity, quantities);
  if (o.degree < 0 || o.degree > most_reference_degree)
    refuse("--degree", fmt::format("{}", o.degree), fmt::format("accepted: 1 to {}", most_reference_degree));
  if (o.time && !(*o.time >= 0 && std::isfinite(*o.time)))
    refuse("--time", fmt::format("{}", *o.time), "accepted: a number of at least 0");
  check_that_it_is_used(o);
}

/// By the names of any system on a sphere.
sphere_function observable_of(const sphere_problem& p, const std::string& name) {
  if (const auto f = named_observable(name, p)) return *f;
  refuse_observable(name, named_observables());
}

/// The root of the mean square of f over the sphere.
double size_of(const sphere_problem& p, const sphere_function& f) {
  const auto on_unit = [&](const Eigen::Vector3d& x) { return f(p.radius * x); };
  return harmonic_coefficients(on_unit, 8).stableNorm() / unit_of_mean;
}

/// The rate at which neighbouring orbits run apart; of a body next to spherical, a millionth of the rotation.
double shear_of(const sphere_problem& p) {
  return p.radius * std::max(p.spread(), 1e-6 * p.quadratic.diagonal().cwiseAbs().maxCoeff());
}

/// Of the Gibbs law, where they have a closed form.
std::optional<reference_value> closed_form(const subject& s, const std::string& observable) {
  if (!s.offers->gibbs || s.sphere()->spread() == 0) return std::nullopt;
  const auto law = s.offers->gibbs();
  const auto certain = [&](double value) {
    return reference_value{value, law.relative_uncertainty() * std::fabs(value)};
  };
  if (observable == "energy") return certain(law.mean_energy());
  if (observable == "pi1^2") return certain(law.mean_square(0));
  if (observable == "pi2^2") return certain(law.mean_square(1));
  if (observable == "pi3^2") return certain(law.mean_square(2));
  return std::nullopt;
}

void answer_expectation(const subject& bound, const reference_options& o, reference_answer& out) {
  const auto& s = bound.scene;
  const auto& p = *bound.sphere();
  const Eigen::Vector3d start(s.momentum[0], s.momentum[1], s.momentum[2]);
  out.observable = o.observable.value_or(usual_observable);
  out.time = o.time.value_or(s.horizon);
  const auto f = observable_of(p, out.observable);
  const auto found = expectation(p, f, start, *out.time, value_tolerance * size_of(p, f), o.degree);
  out.method = !p.has_noise()    ? "no noise: the one path, by Boost.Odeint"
               : found.forgotten ? "the stationary law in spherical harmonics: the start is forgotten"
                                 : "Kolmogorov's backward equation in spherical harmonics";
  if (found.relaxed) out.method += ", until only the stationary mean is left";
  take(s, found, out);
}

void answer_gibbs(const subject& bound, const reference_options& o, reference_answer& out) {
  const auto& s = bound.scene;
  const auto& p = *bound.sphere();
  out.observable = o.observable.value_or(usual_observable);
  const auto f = observable_of(p, out.observable);
  if (!unit_of(p, f)) refuse_scene(s, out, leaves_double_precision);
  const bool isotropic = bound.model->noise() == noise_class::isotropic;
  if (const auto value = isotropic && o.degree == 0 ? closed_form(bound, out.observable) : std::nullopt) {
    out.method = "the Gibbs law exp(-2 theta h / sigma^2), by Bessel functions and adaptive quadrature";
    return take(s, *value, out);
  }
  out.method = isotropic ? "the stationary density, here the Gibbs law, in spherical harmonics"
                         : "the stationary density in spherical harmonics; the noise is not isotropic and constant, so "
                           "no Gibbs law is assumed";
  take(s, stationary_mean(p, f, value_tolerance * size_of(p, f), o.degree), out);
}

void answer_lyapunov(const scene& s, const sphere_problem& p, const reference_options& o, reference_answer& out) {
  const auto found = lyapunov(p, exponent_tolerance * shear_of(p), o.degree);
  out.method = "the stationary law of tangent directions in Wigner functions (Furstenberg-Khasminskii)";
  take(s, {found.lambda1, found.uncertainty, found.degree, found.reason}, out, std::fabs(found.sum));
  out.sum = found.sum;
  out.dimension = found.dimension;
}

}  // namespace

reference_answer reference(const scene& s, const reference_options& o) {
  gsl_set_error_handler_off();
  check(o);
  const auto bound = bind_scene(s);
  require_scale(bound);
  if (!bound.sphere()) return reference_off_sphere(bound, o);
  const auto& p = *bound.sphere();
  reference_answer out;
  out.quantity = o.quantity;
  if (!p.has_noise() && o.quantity != "expectation") {
    out.quantity = "expectation";
    answer_expectation(bound, {out.quantity, o.observable, {}, 0}, out);
    out.reason = fmt::format(
        "asked for {}: no noise, so there is no density, no gap and no random flow; what remains, and is answered, is "
        "the path's own value at the horizon (--quantity expectation)",
        o.quantity);
    return out;
  }
  if (o.quantity == "expectation") answer_expectation(bound, o, out);
  if (o.quantity == "gibbs") answer_gibbs(bound, o, out);
  if (o.quantity == "lyapunov") answer_lyapunov(s, p, o, out);
  if (o.quantity == "gap") {
    out.method = "the least decay rate of Kolmogorov's operator in spherical harmonics";
    const double rate = noise_rate(p);
    auto found = spectral_gap(p, finest_rate_tolerance * rate, o.degree);
    if (found.value && found.uncertainty <= rate_tolerance * rate) found.reason.clear();
    take(s, found, out);
  }
  return out;
}

}  // namespace polhode
