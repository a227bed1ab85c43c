// SPDX-License-Identifier: Apache-2.0
// The Maxwell-Bloch equations: their table, what they offer, and their faces.
#include <polhode/systems/maxwell_bloch.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <gsl/gsl_sf_bessel.h>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

[[maybe_unused]] maxwell_bloch make_maxwell_bloch(const report::scene& s) {
  std::vector<maxwell_bloch::column> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back({{v[0], v[1], v[2]}});
  return {dissipation_of(s), maxwell_bloch::from_vectors(vectors)};
}

}  // namespace
#if defined(POLHODE_ISA)
template <>
struct faces_for<maxwell_bloch> : kernels_beside<euler_maruyama, heun, milstein, milstein_no_area, implicit_midpoint> {
};
#endif

}  // namespace polhode

POLHODE_BEHIND_FACES(maxwell_bloch, polhode::make_maxwell_bloch);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

using report::number_rows;
using report::shape;

double radius_of(const report::scene& s) { return std::hypot(s.momentum[1], s.momentum[2]); }

/// x_1 is that of the start and what the fall from the top adds: x_1^2 <= x_1(0)^2 + 4 |(x_2, x_3)|.
rate_bounds maxwell_bloch_rates(const report::scene& s) {
  const double radius = radius_of(s), field = std::hypot(s.momentum[0], 2 * std::sqrt(radius)),
               size = std::hypot(field, radius);
  rate_bounds out;
  out.motion = field + radius / size;
  out.damping = radius + field * radius * radius / size;
  out.dissipation = dissipation_of(s) * out.damping;
  for (const auto& v : noise_vectors_of(s)) {
    const double shift = std::hypot(v[1], v[2]) * radius / size;
    out.noise += v[0] * v[0] + shift * shift;
  }
  return out;
}

/// The law exp(-beta h): x_1 is normal of variance 1/beta, and the angle of (x_2, x_3) has von Mises' law.
std::optional<reference_value> gibbs_mean(double radius, double beta, std::string_view name) {
  const double x = beta * radius, whole = gsl_sf_bessel_I0_scaled(x);
  const auto certain = [](double value) {
    return reference_value{.value = value, .uncertainty = 1e-14 * std::fabs(value)};
  };
  const double cosine = -gsl_sf_bessel_I1_scaled(x) / whole, twice = gsl_sf_bessel_In_scaled(2, x) / whole,
               square = 0.5 * radius * radius;
  if (name == "energy") return certain(0.5 / beta + radius * cosine);
  if (name == "x1" || name == "mu_1" || name == "x2" || name == "mu_2") return certain(0);
  if (name == "x3" || name == "mu_3") return certain(radius * cosine);
  if (name == "x1^2") return certain(1 / beta);
  if (name == "x2^2") return certain(square * (1 - twice));
  if (name == "x3^2") return certain(square * (1 + twice));
  return std::nullopt;
}

/// x_1 alone: a normal number of variance 1/beta.
known_marginal law_of_the_field(double beta) {
  return {"x1", [](std::span<const double> mu) { return mu[0]; },
          [root = std::sqrt(beta / 2)](double x) { return 0.5 * std::erfc(-root * x); }};
}

std::string maxwell_bloch_in_cpp(const report::scene& s) {
  std::vector<std::string> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back(fmt::format("{{{{{}}}}}", fmt::join(v, ", ")));
  if (vectors.empty())
    return fmt::format("  const maxwell_bloch body({}, maxwell_bloch::isotropic(0));\n", dissipation_of(s));
  return fmt::format(
      "  const vec<double, 3> sigma[] = {{{}}};\n  const maxwell_bloch body({}, maxwell_bloch::from_vectors(sigma));\n",
      fmt::join(vectors, ", "), dissipation_of(s));
}

capabilities maxwell_bloch_offers(const report::scene& s) {
  capabilities out{.rates = maxwell_bloch_rates(s)};
  const double strength = isotropic_strength(s);
  if (strength > 0 && dissipation_of(s) > 0)
    out.gibbs_mean = [radius = radius_of(s), beta = 2 * dissipation_of(s) / (strength * strength)](
                         std::string_view name) { return gibbs_mean(radius, beta, name); };
  if (out.gibbs_mean) out.gibbs_marginals = {law_of_the_field(2 * dissipation_of(s) / (strength * strength))};
  out.no_gibbs_mean = "without dissipation nothing holds x_1 on an orbit that is not compact";
  out.components = {"x1", "x2", "x3"};
  out.in_cpp = maxwell_bloch_in_cpp(s);
  return out;
}

/// (x_2, x_3) is not zero, as nothing moves there.
parameter_rule start_rule() {
  auto rule = vector_of("momentum", 3, "1 / time; 1 / time^2", "initial x_1, x_2, x_3");
  rule.accepts += ", the last two not both zero";
  rule.read = [](const number_rows& given, shape s) {
    const bool fits = s == shape::vector && given[0].size() == 3 && (given[0][1] != 0 || given[0][2] != 0);
    return fits ? std::optional(given) : std::nullopt;
  };
  return rule;
}

}  // namespace

system_entry maxwell_bloch_system();

system_entry maxwell_bloch_system() {
  return {
      .name = "maxwell_bloch",
      .title = "Dissipative stochastic Maxwell-Bloch equations on se(2)*, Casimir |(x_2, x_3)|; orbits are cylinders",
      .dimension = 3,
      .unit = "1 / time",
      .parameters = {dissipation_strength("time^3", "dissipation: dh/dt = -theta |ad*_Omega mu|^2"),
                     noise_vectors(3, "1 / time^(1/2)")},
      .observables = {{"energy", "h"},
                      {"x1", "field"},
                      {"x2", "polarisation"},
                      {"x3", "inversion"},
                      {"x1^2", "x_1^2"},
                      {"x2^2", "x_2^2"},
                      {"x3^2", "x_3^2"}},
      .bind = POLHODE_BOUND_TO_SCHEMES(maxwell_bloch),
      .offers = maxwell_bloch_offers,
      .momentum = start_rule()};
}

}  // namespace polhode
#endif
