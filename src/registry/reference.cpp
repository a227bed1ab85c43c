#include "registry/reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>

#include "experiments/transfer.hpp"
#include "references/gibbs.hpp"
#include "references/lyapunov.hpp"
#include "registry/nearest.hpp"
#include "registry/text.hpp"
#include "registry/verify.hpp"
#include "reports/model/errors.hpp"

namespace polhode {
namespace {

constexpr double value_tolerance = 1e-11, rate_tolerance = 1e-9, exponent_tolerance = 1e-7;
const std::vector<std::string> quantities{"expectation", "gibbs", "lyapunov", "gap"};

[[noreturn]] void refuse(std::string_view option, std::string_view value, std::string_view fault) {
  throw input_error(fmt::format("{} '{}': {}", option, one_line(value, 60), fault));
}

void check(const reference_options& o) {
  if (o.quantity.empty())
    throw input_error(fmt::format("--quantity is missing; accepted: {}", fmt::join(quantities, ", ")));
  if (std::ranges::find(quantities, o.quantity) == quantities.end())
    refuse("--quantity", o.quantity,
           fmt::format("not known{}; accepted: {}", did_you_mean(o.quantity, quantities), fmt::join(quantities, ", ")));
  if (o.degree < 0 || o.degree > most_reference_degree)
    refuse("--degree", fmt::format("{}", o.degree), fmt::format("accepted: 1 to {}", most_reference_degree));
  if (o.time && !(*o.time >= 0 && std::isfinite(*o.time)))
    refuse("--time", fmt::format("{}", *o.time), "accepted: a number of at least 0");
}

sphere_function observable_of(const scene& s, const std::string& name) {
  if (const auto f = named_observable(name, s.inertia)) return *f;
  std::vector<std::string> known;
  for (const auto& entry : list_observables()) known.push_back(entry.name);
  refuse("--observable", name,
         fmt::format("not known{}; accepted: {}", did_you_mean(name, known), fmt::join(known, ", ")));
}

/// The moments of the Gibbs law that have a closed form.
std::optional<double> closed_form(const sphere_problem& p, const std::string& observable) {
  const auto& i = p.inertia;
  if (i[0] == i[1] && i[1] == i[2]) return std::nullopt;
  const gibbs_law law(i, p.radius, 2 * p.theta / p.covariance(0, 0));
  if (observable == "energy") return law.mean_energy();
  if (observable == "pi1^2") return law.mean_square(0);
  if (observable == "pi2^2") return law.mean_square(1);
  if (observable == "pi3^2") return law.mean_square(2);
  return std::nullopt;
}

void take(const scene& s, const reference_value& found, reference_answer& out) {
  if (!found.value) throw input_error(fmt::format("scene {}: {}: {}", s.name, out.quantity, found.reason));
  out.value = *found.value;
  out.uncertainty = found.uncertainty;
  out.degree = found.degree;
  out.reason = found.reason;
}

void answer_expectation(const scene& s, const sphere_problem& p, const reference_options& o, reference_answer& out) {
  const Eigen::Vector3d start(s.momentum[0], s.momentum[1], s.momentum[2]);
  out.observable = o.observable;
  out.time = o.time.value_or(s.horizon);
  out.method = "Kolmogorov's backward equation in spherical harmonics";
  take(s, expectation(p, observable_of(s, o.observable), start, *out.time, value_tolerance, o.degree), out);
}

void answer_gibbs(const scene& s, const sphere_problem& p, const reference_options& o, reference_answer& out) {
  const auto f = observable_of(s, o.observable);
  const bool isotropic = bind_scene(s).model->noise() == noise_class::isotropic;
  out.observable = o.observable;
  if (const auto value = isotropic && o.degree == 0 ? closed_form(p, o.observable) : std::nullopt) {
    out.value = *value;
    out.uncertainty = 1e-11 * std::max(1.0, std::fabs(*value));
    out.method = "the Gibbs law exp(-2 theta h / sigma^2), by complete elliptic integrals";
    return;
  }
  out.method = isotropic
                   ? "the stationary density, here the Gibbs law, in spherical harmonics"
                   : "the stationary density in spherical harmonics; the noise is not isotropic, so it is no Gibbs law";
  take(s, mean(p, stationary(p, value_tolerance, o.degree), f), out);
}

void answer_lyapunov(const scene& s, const sphere_problem& p, const reference_options& o, reference_answer& out) {
  const auto found = lyapunov(p, exponent_tolerance, o.degree);
  out.method = "the stationary law of tangent directions in Wigner functions (Furstenberg-Khasminskii)";
  take(s, {found.lambda1, found.uncertainty, found.degree, found.reason}, out);
  out.sum = found.sum;
  out.dimension = found.dimension;
}

}  // namespace

reference_answer reference(const scene& s, const reference_options& o) {
  gsl_set_error_handler_off();
  check(o);
  const auto problem = sphere_problem_of(bind_scene(s));
  if (!problem)
    throw input_error(
        fmt::format("scene {}: system = \"{}\" has no exact references; accepted: rigid_body", s.name, s.system));
  const auto& p = *problem;
  reference_answer out;
  out.quantity = o.quantity;
  if (o.quantity == "expectation") answer_expectation(s, p, o, out);
  if (o.quantity == "gibbs") answer_gibbs(s, p, o, out);
  if (o.quantity == "lyapunov") answer_lyapunov(s, p, o, out);
  if (o.quantity == "gap") {
    out.method = "the least decay rate of Kolmogorov's operator in spherical harmonics";
    take(s, spectral_gap(p, rate_tolerance, o.degree), out);
  }
  return out;
}

}  // namespace polhode
