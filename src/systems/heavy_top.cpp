// SPDX-License-Identifier: Apache-2.0
// The heavy top: its table, what it offers, and its faces.
#include <polhode/systems/heavy_top.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "systems/heavy_top/heavy_top_gibbs.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

#if defined(POLHODE_ISA)
#include "ensemble/faces/face_with_flows.hpp"
#include "systems/heavy_top/heavy_top_at.hpp"
#endif

namespace polhode {
namespace {

[[maybe_unused]] heavy_top make_heavy_top(const report::scene& s) {
  std::vector<heavy_top::column> vectors;
  for (const auto& v : noise_vectors_of(s)) std::ranges::copy(v, vectors.emplace_back().c.begin());
  return {three(s.vector("inertia")), s.number("weight"), three(s.vector("axis")), dissipation_of(s),
          heavy_top::from_vectors(vectors)};
}

}  // namespace

#if defined(POLHODE_ISA)
template <>
struct faces_for<heavy_top> : plain_faces {
  static std::shared_ptr<const face> values(const heavy_top& system, std::span<const double> momentum, double dt) {
    return bound_where_it_fits<heavy_top, heavy_top_at>(system, momentum, dt);
  }
};
#endif

}  // namespace polhode

POLHODE_BEHIND_FACES(heavy_top, polhode::make_heavy_top);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

using number_rows = report::number_rows;
using report::shape;

constexpr double length_tolerance = 1e-9;  // of Gamma

std::span<const double> part(std::span<const double> mu, std::size_t which) { return mu.subspan(3 * which, 3); }

/// |Pi| is that of the start and what gravity can add: |Pi|^2 <= |Pi(0)|^2 + 4 greatest I weight |axis|.
rate_bounds heavy_top_rates(const report::scene& s) {
  const auto [least, greatest] = std::ranges::minmax(s.vector("inertia"));
  const double pull = std::fabs(s.number("weight")) * length(s.vector("axis"));
  const double momentum = std::hypot(length(part(s.momentum, 0)), 2 * std::sqrt(greatest * pull));
  const double size = std::hypot(momentum, 1.0);
  rate_bounds out;
  out.motion = momentum / least + pull / size;
  out.damping = momentum * momentum * (1 / least - 1 / greatest) + pull + momentum / (least * size);
  out.dissipation = dissipation_of(s) * out.damping;
  for (const auto& v : noise_vectors_of(s))
    out.noise += std::pow(length(part(v, 0)), 2) + std::pow(length(part(v, 1)) / size, 2);
  return out;
}

std::string heavy_top_in_cpp(const report::scene& s) {
  std::vector<std::string> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back(fmt::format("{{{{{}}}}}", fmt::join(v, ", ")));
  const std::string list =
      vectors.empty() ? "" : fmt::format("  const vec<double, 6> sigma[] = {{{}}};\n", fmt::join(vectors, ", "));
  return fmt::format("{}  const heavy_top body({{{}}}, {}, {{{}}}, {}, heavy_top::{});\n", list,
                     fmt::join(s.vector("inertia"), ", "), s.number("weight"), fmt::join(s.vector("axis"), ", "),
                     dissipation_of(s), vectors.empty() ? "isotropic(0)" : "from_vectors(sigma)");
}

heavy_top_gibbs gibbs_of_heavy_top(const report::scene& s, double strength) {
  const Eigen::Vector3d pi(s.momentum.data()), gamma(s.momentum.data() + 3);
  return {.inertia = Eigen::Vector3d(s.vector("inertia").data()),
          .pull = s.number("weight") * Eigen::Vector3d(s.vector("axis").data()),
          .along = pi.dot(gamma),
          .beta = 2 * dissipation_of(s) / (strength * strength)};
}

/// At fixed Gamma, Pi is normal in two directions, so that beta times what its energy has beyond the least that
/// Pi.Gamma allows, k^2 / (2 Gamma.I Gamma), is the half of a chi squared of two degrees: 1 - exp(-x).
known_marginal law_of_kinetic_energy(const heavy_top_gibbs& law) {
  return {"kinetic energy beyond that of Pi.Gamma",
          [=](std::span<const double> mu) {
            double kinetic = 0, along = 0;
            for (std::size_t k = 0; k < 3; ++k) {
              const double i = law.inertia[static_cast<Eigen::Index>(k)];
              kinetic += mu[k] * mu[k] / (2 * i);
              along += i * mu[k + 3] * mu[k + 3];
            }
            return kinetic - law.along * law.along / (2 * along);
          },
          [beta = law.beta](double x) { return -std::expm1(-beta * std::max(0.0, x)); }};
}

capabilities heavy_top_offers(const report::scene& s) {
  capabilities out{.rates = heavy_top_rates(s)};
  const double strength = isotropic_strength(s);
  if (strength > 0 && dissipation_of(s) > 0) {
    const auto law = gibbs_of_heavy_top(s, strength);
    out.gibbs_mean = [law](std::string_view observable) { return law.mean(observable); };
    out.gibbs_marginals = {law_of_kinetic_energy(law)};
  }
  out.no_gibbs_mean = "without dissipation nothing holds |Pi| on an orbit that is not compact";
  out.components = {"pi1", "pi2", "pi3", "gamma1", "gamma2", "gamma3"};
  out.in_cpp = heavy_top_in_cpp(s);
  return out;
}

std::vector<observable_entry> heavy_top_observables() {
  std::vector<observable_entry> out{{"energy", "h"}};
  for (int k = 1; k <= 3; ++k) out.push_back({fmt::format("pi{}", k), fmt::format("Pi_{}", k)});
  for (int k = 1; k <= 3; ++k) out.push_back({fmt::format("gamma{}", k), fmt::format("Gamma_{}", k)});
  for (int k = 1; k <= 3; ++k) out.push_back({fmt::format("pi{}^2", k), fmt::format("Pi_{}^2", k)});
  for (int k = 1; k <= 3; ++k) out.push_back({fmt::format("gamma{}^2", k), fmt::format("Gamma_{}^2", k)});
  return out;
}

/// Pi, then Gamma, a direction.
parameter_rule momentum_and_vertical() {
  auto rule = vector_of("momentum", 6, "inertia / time; 1", "initial Pi (any), then Gamma (of length one)");
  rule.accepts += ", the last three of length 1";
  rule.read = [](const number_rows& given, shape s) -> std::optional<number_rows> {
    const bool fits =
        s == shape::vector && given[0].size() == 6 && std::fabs(length(part(given[0], 1)) - 1) <= length_tolerance;
    return fits ? std::optional(given) : std::nullopt;
  };
  return rule;
}

}  // namespace

system_entry heavy_top_system();

system_entry heavy_top_system() {
  return {.name = "heavy_top",
          .title = "Dissipative stochastic heavy top on se(3)*, Casimirs |Gamma| and Pi.Gamma; orbits are not compact",
          .dimension = 6,
          .unit = "inertia / time",
          .parameters = {positive_vector_of("inertia", 3, "inertia", "moments of inertia about the fixed point"),
                         number_of("weight", "inertia / time^2", "m g l: h = sum Pi_k^2 / 2 I_k + weight Gamma.axis"),
                         vector_of("axis", 3, "1", "from the fixed point to the centre of mass, seen from the body"),
                         dissipation_strength("time / inertia", "dissipation: dh/dt = -theta |ad*_Omega mu|^2"),
                         noise_vectors(6, "1 / time^(1/2)")},
          .observables = heavy_top_observables(),
          .bind = POLHODE_BOUND_TO_SCHEMES(heavy_top),
          .offers = heavy_top_offers,
          .momentum = momentum_and_vertical()};
}

}  // namespace polhode
#endif
