// SPDX-License-Identifier: Apache-2.0
// The pair of coupled bodies: its table, what it offers, and its faces.
#include <polhode/systems/so4_body.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "problem/momentum_pair.hpp"
#include "problem/vectors.hpp"
#include "sphere/closed_forms/chain_gibbs.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

#if defined(POLHODE_ISA)
#include "ensemble/faces/face_with_flows.hpp"
#include "systems/so4_body/so4_body_at.hpp"
#endif

namespace polhode {
namespace {

[[maybe_unused]] so4_body make_so4_body(const report::scene& s) {
  std::array<double, 6> inertia{};
  std::ranges::copy(s.vector("inertia"), inertia.begin());
  std::vector<so4_body::column> vectors;
  for (const auto& v : noise_vectors_of(s)) std::ranges::copy(v, vectors.emplace_back().c.begin());
  return {inertia, s.number("coupling"), dissipation_of(s), so4_body::from_vectors(vectors)};
}

}  // namespace

#if defined(POLHODE_ISA)
template <>
struct faces_for<so4_body> : kernels_beside<milstein> {
  static std::shared_ptr<const face> values(const so4_body& system, std::span<const double> momentum, double dt) {
    return bound_where_it_fits<so4_body, so4_body_at>(system, momentum, dt);
  }
};
#endif

}  // namespace polhode

POLHODE_BEHIND_FACES(so4_body, polhode::make_so4_body);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

/// The faster of both parts decides.
rate_bounds so4_body_rates(const report::scene& s) {
  const double coupling = std::fabs(s.number("coupling"));
  rate_bounds out;
  for (const std::size_t part : {0U, 3U}) {
    const auto of_part = [&](const std::vector<double>& v, std::size_t from) { return std::span(v).subspan(from, 3); };
    const auto [least, greatest] = std::ranges::minmax(of_part(s.vector("inertia"), part));
    const double own = length(of_part(s.momentum, part)), other = length(of_part(s.momentum, 3 - part));
    out.motion = std::max(out.motion, own / least + coupling * other);
    out.damping = std::max(out.damping, own * (own * (1 / least - 1 / greatest) + coupling * other));
    double noise = 0;
    for (const auto& v : noise_vectors_of(s)) noise += std::pow(length(of_part(v, part)), 2);
    out.noise = std::max(out.noise, noise);
  }
  out.dissipation = dissipation_of(s) * out.damping;
  return out;
}

std::string so4_body_in_cpp(const report::scene& s) {
  std::vector<std::string> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back(fmt::format("{{{{{}}}}}", fmt::join(v, ", ")));
  const std::string head = fmt::format("  const so4_body body({{{}}}, {}, {}, ", fmt::join(s.vector("inertia"), ", "),
                                       s.number("coupling"), dissipation_of(s));
  if (vectors.empty()) return head + "so4_body::isotropic(0));\n";
  return fmt::format("  const vec<double, 6> sigma[] = {{{}}};\n{}so4_body::from_vectors(sigma));\n",
                     fmt::join(vectors, ", "), head);
}

Eigen::Matrix3d inverse_inertia(const report::scene& s, std::ptrdiff_t first) {
  return Eigen::Vector3d(s.vector("inertia").data() + first).cwiseInverse().asDiagonal();
}

/// beta < 0: none, as the noise is not isotropic.
chain_gibbs gibbs_of_so4_body(const report::scene& s) {
  const double strength = isotropic_strength(s);
  chain_gibbs law{.sites = {},
                  .exchange = Eigen::Matrix2d::Constant(s.number("coupling")),
                  .beta = strength > 0 ? 2 * dissipation_of(s) / (strength * strength) : -1};
  for (const std::size_t part : {0U, 3U})
    law.sites.push_back({inverse_inertia(s, static_cast<std::ptrdiff_t>(part)), Eigen::Vector3d::Zero(),
                         length(std::span(s.momentum).subspan(part, 3))});
  return law;
}

capabilities so4_body_offers(const report::scene& s) {
  capabilities out{.rates = so4_body_rates(s)};
  if (const auto law = gibbs_of_so4_body(s); law.beta >= 0)
    out.gibbs_mean = [law](std::string_view observable) { return law.mean(observable); };
  out.pair =
      momentum_pair(s, {inverse_inertia(s, 0), inverse_inertia(s, 3)}, Eigen::Vector3d::Zero(), s.number("coupling"));
  out.in_unit = [=](int power) { return with_momentum_unit(s, power); };
  out.in_cpp = so4_body_in_cpp(s);
  return out;
}

std::vector<observable_entry> so4_body_observables() {
  std::vector<observable_entry> out{{"energy", "h"}};
  for (int k = 1; k <= 6; ++k) out.push_back({fmt::format("mu_{}", k), fmt::format("component {}", k)});
  for (int k = 1; k <= 6; ++k) out.push_back({fmt::format("mu_{}^2", k), fmt::format("mu_{}^2", k)});
  return out;
}

}  // namespace

system_entry so4_body_system();

system_entry so4_body_system() {
  return {.name = "so4_body",
          .title =
              "Two dissipative stochastic bodies on so(4)* = so(3)* + so(3)*, coupled through the energy; two Casimirs",
          .dimension = 6,
          .unit = "inertia / time",
          .parameters = {positive_vector_of("inertia", 6, "inertia", "moments of inertia, three of each body"),
                         number_of("coupling", "1 / inertia", "k in h = sum mu_k^2 / 2 I_k + k Pi_1.Pi_2"),
                         dissipation_strength("time / inertia", "dissipation: dh/dt = -theta |ad*_Omega mu|^2"),
                         noise_vectors(6, "1 / time^(1/2)")},
          .observables = so4_body_observables(),
          .bind = POLHODE_BOUND_TO_SCHEMES(so4_body),
          .offers = so4_body_offers};
}

}  // namespace polhode
#endif
