// SPDX-License-Identifier: Apache-2.0
// Coupled spins: their table, what they offer, and their faces; and that of the vortices, which are
// spins of another energy and cost nothing more to compile here.
#include <polhode/systems/spins.hpp>
#include <polhode/systems/vortices.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "problem/momentum_pair.hpp"
#include "problem/vectors.hpp"
#include "sphere/closed_forms/chain_gibbs.hpp"
#include "systems/cpp_text.hpp"
#include "systems/spins/spins_of.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"
#include "systems/vortices/circulations.hpp"

namespace polhode {
namespace {

[[maybe_unused]] spins make_spins(const report::scene& s) {
  return spins_of<spins>(s, spins::from_vectors(noise_vectors_of(s), static_cast<int>(s.momentum.size())));
}
[[maybe_unused]] spins make_vortices(const report::scene& s) {
  return vortices(circulations_of(s), dissipation_of(s),
                  spins::from_vectors(noise_vectors_of(s), static_cast<int>(s.momentum.size())));
}

}  // namespace
}  // namespace polhode

POLHODE_BEHIND_FACES(spins, polhode::make_spins);
POLHODE_BEHIND_FACES(vortices, polhode::make_vortices);
POLHODE_FACED_ELSEWHERE(spin_pair);  // in spin_pair.cpp

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

using report::number_rows;
using report::shape;

std::size_t count_of(const report::scene& s) { return static_cast<std::size_t>(s.number("count")); }

std::vector<double> lengths_of(const report::scene& s) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count_of(s); ++i) out.push_back(length(std::span(s.momentum).subspan(3 * i, 3)));
  return out;
}

/// The fastest spin decides.
rate_bounds spins_rates(const report::scene& s) {
  const auto quadratic = matrix_of(s.vectors("quadratic"));
  const double anisotropy = quadratic.norm(), field = length(s.vector("field"));
  const auto lengths = lengths_of(s);
  const auto& exchange = s.vectors("exchange");
  rate_bounds out;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    double motion = anisotropy * lengths[i] + field;
    for (std::size_t j = 0; j < lengths.size(); ++j)
      if (j != i) motion += std::fabs(exchange[i][j]) * lengths[j];
    out.motion = std::max(out.motion, motion);
    out.damping = std::max(out.damping, lengths[i] * motion);
    double noise = 0;
    for (const auto& v : noise_vectors_of(s)) noise += std::pow(length(std::span(v).subspan(3 * i, 3)), 2);
    out.noise = std::max(out.noise, noise);
  }
  out.dissipation = dissipation_of(s) * out.damping;
  return out;
}

std::string matrix_in_cpp(const char* name, const number_rows& rows) {
  std::vector<double> entries;
  for (const auto& row : rows) entries.insert(entries.end(), row.begin(), row.end());
  return fmt::format("  Eigen::MatrixXd {0}({1}, {1});\n  {0} << {2};\n", name, rows.size(), fmt::join(entries, ", "));
}

std::string spins_in_cpp(const report::scene& s) {
  return matrix_in_cpp("quadratic", s.vectors("quadratic")) + matrix_in_cpp("exchange", s.vectors("exchange")) +
         noise_in_cpp(s) +
         fmt::format("  const spins body(quadratic, {}, exchange, {}, spins::from_vectors(sigma, {}));\n",
                     list_in_cpp(s.vector("field")), dissipation_of(s), s.momentum.size());
}

/// Of two spins bound by exchange alone: J u, u = S_1.S_2, has the density exp(-beta J u) on |u| <= |S_1| |S_2|.
known_marginal law_of_a_bond(double most, double beta, const report::scene& s) {
  const double exchange = s.vectors("exchange")[0][1];
  return {"energy",
          [exchange](std::span<const double> mu) { return exchange * (mu[0] * mu[3] + mu[1] * mu[4] + mu[2] * mu[5]); },
          [most, beta](double e) {
            const double at = std::clamp(e, -most, most);
            return beta * most < 1e-9 ? (at + most) / (2 * most)
                                      : std::expm1(-beta * (at + most)) / std::expm1(-2 * beta * most);
          }};
}

capabilities spins_offers(const report::scene& s) {
  capabilities out{.rates = spins_rates(s)};
  out.in_cpp = spins_in_cpp(s);
  out.in_cpp_sized = true;
  const double strength = isotropic_strength(s);
  chain_gibbs law{.sites = {},
                  .exchange = matrix_of(s.vectors("exchange")),
                  .beta = strength > 0 ? 2 * dissipation_of(s) / (strength * strength) : 0};
  const Eigen::Matrix3d quadratic = matrix_of(s.vectors("quadratic"));
  const Eigen::Vector3d field(s.vector("field").data());
  for (const double length : lengths_of(s)) law.sites.push_back({quadratic, field, length});
  if (count_of(s) == 2) out.pair = momentum_pair(s, {quadratic, quadratic}, field, law.exchange(0, 1));
  if (strength > 0 && law.solvable())
    out.gibbs_mean = [law](std::string_view observable) { return law.mean(observable); };
  const double bond =
      law.sites.size() == 2 ? std::fabs(law.exchange(0, 1)) * law.sites[0].length * law.sites[1].length : 0;
  if (strength > 0 && bond > 0 && quadratic.isZero(0) && law.sites[0].field.isZero(0))
    out.gibbs_marginals = {law_of_a_bond(bond, law.beta, s)};
  out.no_gibbs_mean = "bonds that form neither chains nor rings: no closed form of the law's means";
  for (std::size_t i = 1; i <= count_of(s); ++i)
    for (int k = 1; k <= 3; ++k) out.components.push_back(fmt::format("s{}_{}", i, k));
  return out;
}

parameter_rule count_rule() {
  auto rule = number_of("count", "1", "N, the number of spins");
  rule.accepts = fmt::format("an integer from 1 to {}", most_spins);
  rule.read = [](const number_rows& given, shape s) -> std::optional<number_rows> {
    const bool fits =
        s == shape::number && given[0][0] >= 1 && given[0][0] <= most_spins && given[0][0] == std::floor(given[0][0]);
    return fits ? std::optional(given) : std::nullopt;
  };
  return rule;
}

parameter_rule chain_rule() {
  auto rule = number_of("open", "1", "whether the bonds of a number `exchange` form a chain and no ring");
  rule.accepts = "true or false";
  rule.is_flag = true;
  rule.fallback = number_rows{{0}};
  return rule;
}

/// J between neighbours; a ring of two has one bond.
number_rows bonds_between_neighbours(std::size_t count, bool open, double strength) {
  number_rows out(count, std::vector<double>(count, 0.0));
  for (std::size_t i = 0; i + 1 < count; ++i) out[i][i + 1] = out[i + 1][i] = strength;
  if (!open && count > 2) out[0][count - 1] = out[count - 1][0] = strength;
  return out;
}

parameter_rule exchange_for(std::size_t count, bool open) {
  auto rule = symmetric_matrix("exchange", count, "1 / (momentum time)", "J_ij in h; a number: between neighbours");
  rule.accepts = fmt::format("a finite number, or a symmetric {0} x {0} matrix of finite numbers", count);
  rule.read = [=, matrix = rule.read](const number_rows& given, shape s) {
    if (s == shape::number) return std::optional(bonds_between_neighbours(count, open, given[0][0]));
    return s == shape::vectors ? matrix(given, s) : std::nullopt;
  };
  rule.fallback = bonds_between_neighbours(count, open, 0);
  return rule;
}

parameter_rule exchange_rule() {
  return refined_by([](const report::scene& s) { return exchange_for(count_of(s), s.number("open") != 0); },
                    exchange_for(1, false), "a finite number, or a symmetric count x count matrix of finite numbers");
}

parameter_rule noise_rule() {
  const auto noise_of = [](std::size_t count) { return noise_vectors(3 * count, "1 / time^(1/2)"); };
  return refined_by([=](const report::scene& s) { return noise_of(count_of(s)); }, noise_of(1),
                    "a finite number, 3 count of them, or a list of vectors of 3 count");
}

/// One spin for all, or each of them; none of length zero.
parameter_rule spins_states(std::size_t count) {
  auto rule =
      vector_of("momentum", 3 * count, "momentum", "initial spins, one after the other; three numbers: all alike");
  rule.accepts = fmt::format("three finite numbers, or {} of them, no spin zero", 3 * count);
  rule.read = [=](const number_rows& given, shape s) -> std::optional<number_rows> {
    if (s != shape::vector) return std::nullopt;
    std::vector<double> all;
    if (given[0].size() == 3)
      for (std::size_t i = 0; i < count; ++i) all.insert(all.end(), given[0].begin(), given[0].end());
    else
      all = given[0];
    if (all.size() != 3 * count) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i)
      if (length(std::span(all).subspan(3 * i, 3)) == 0) return std::nullopt;
    return number_rows{all};
  };
  return rule;
}

parameter_rule states_rule() {
  return refined_by([](const report::scene& s) { return spins_states(count_of(s)); }, spins_states(1),
                    "three finite numbers, or 3 count of them, no spin zero");
}

template <class Value>
parameter_rule with_fallback(parameter_rule rule, Value value) {
  rule.fallback = std::move(value);
  return rule;
}

std::vector<observable_entry> spins_observables() {
  return {{"energy", "h"},
          {"s1_3", "third component of the first spin; so for every spin and component"},
          {"s1_3^2", "its square; so for every spin and component"}};
}

subject bind_to_schemes(const report::scene& s) {
  const bool pair = s.momentum.size() == 6;
  return pair ? POLHODE_BOUND_TO_SCHEMES(spin_pair)(s) : POLHODE_BOUND_TO_SCHEMES(spins)(s);
}

}  // namespace

system_entry spins_system();

system_entry spins_system() {
  return {
      .name = "spins",
      .title = fmt::format("Up to {} coupled dissipative stochastic spins on so(3)*^N, N Casimirs |S_i|", most_spins),
      .dimension = 0,
      .unit = "momentum",
      .parameters = {count_rule(),
                     with_fallback(symmetric_matrix("quadratic", 3, "1 / (momentum time)",
                                                    "Lambda in S_i.Lambda S_i / 2, of any signature, of every spin"),
                                   number_rows(3, {0, 0, 0})),
                     with_fallback(vector_of("field", 3, "1 / time", "b in b.S_i, of every spin"),
                                   number_rows{{0, 0, 0}}),
                     chain_rule(), exchange_rule(),
                     dissipation_strength("1 / momentum", "dissipation: dh/dt = -theta sum |S_i x Omega_i|^2"),
                     noise_rule()},
      .observables = spins_observables(),
      .bind = bind_to_schemes,
      .offers = spins_offers,
      .momentum = states_rule()};
}

}  // namespace polhode
#endif
