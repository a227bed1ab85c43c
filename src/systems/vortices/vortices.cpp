// SPDX-License-Identifier: Apache-2.0
// Point vortices: their table and what they offer. Their faces are in spins.cpp.
#include <polhode/systems/vortices.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "systems/cpp_text.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"
#include "systems/vortices/circulations.hpp"

namespace polhode {
namespace {

using report::number_rows;
using report::shape;

constexpr double length_tolerance = 1e-9;  // of |mu_i| / |Gamma_i|
constexpr double one_place = 1e-6;         // vortices nearer than this are in one

/// x_i = -mu_i / Gamma_i, scaled to the sphere.
std::vector<std::vector<double>> positions(std::span<const double> mu, std::span<const double> strengths) {
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    const auto part = mu.subspan(3 * i, 3);
    auto& x = out.emplace_back(part.begin(), part.end());
    for (double& component : x) component /= -std::copysign(length(part), strengths[i]);
  }
  return out;
}

/// Each vortex is turned by the others, and near one of them turns about it: the fastest decides.
rate_bounds rates_of(const report::scene& s) {
  const auto strengths = circulations_of(s);
  const auto x = positions(s.momentum, strengths);
  rate_bounds out;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double motion = 0, noise = 0;
    for (std::size_t j = 0; j < x.size(); ++j)
      if (j != i)
        motion += (std::fabs(strengths[i]) + std::fabs(strengths[j])) /
                  (2 * std::numbers::pi * std::pow(distance(x[i], x[j]), 2));  // 1 - x_i.x_j = |x_i - x_j|^2 / 2
    for (const auto& v : noise_vectors_of(s)) noise += std::pow(length(std::span(v).subspan(3 * i, 3)), 2);
    out.motion = std::max(out.motion, motion);
    out.damping = std::max(out.damping, std::fabs(strengths[i]) * motion);
    out.noise = std::max(out.noise, noise);
  }
  out.dissipation = dissipation_of(s) * out.damping;
  return out;
}

/// Of two vortices: exp(-beta h) is (1 - u)^a, u = x_1.x_2 from -1 to 1, a = beta Gamma_1 Gamma_2 / 4 pi. It can be
/// normalised where a > -1; then E[log(1 - u)] = log 2 - 1 / (a + 1).
std::optional<double> mean_energy_of_two(double product, double beta) {
  const double factor = product / (4 * std::numbers::pi), a = beta * factor;
  if (!(a > -1)) return std::nullopt;
  return -factor * (std::numbers::ln2 - 1 / (a + 1));
}

/// Of the same two: w = (1 - u)/2 has the distribution w^(a + 1), and h = -product/4 pi log(2 w).
known_marginal energy_of_two(double product, double beta) {
  const double factor = product / (4 * std::numbers::pi), power = beta * factor + 1;
  return {"energy",
          [factor, size = std::fabs(product)](std::span<const double> mu) {
            const double sign = factor > 0 ? 1 : -1;
            return -factor * std::log1p(-sign * (mu[0] * mu[3] + mu[1] * mu[4] + mu[2] * mu[5]) / size);
          },
          [factor, power](double h) {
            const double below = std::pow(std::min(1.0, 0.5 * std::exp(-h / factor)), power);
            return factor > 0 ? 1 - below : below;
          }};
}

std::string in_cpp(const report::scene& s) {
  return fmt::format("{}  const spins body = vortices({}, {}, spins::from_vectors(sigma, {}));\n", noise_in_cpp(s),
                     list_in_cpp(circulations_of(s)), dissipation_of(s), s.momentum.size());
}

report::scene in_unit(report::scene s, int power) {
  for (double& strength : s.vector("strengths")) strength = std::ldexp(strength, 2 * power);
  return with_momentum_unit(std::move(s), power);
}

capabilities offers(const report::scene& s) {
  capabilities out{.rates = rates_of(s)};
  const auto strengths = circulations_of(s);
  const double strength = isotropic_strength(s);
  if (strengths.size() == 2 && strength > 0) {
    const double product = strengths[0] * strengths[1], beta = 2 * dissipation_of(s) / (strength * strength);
    if (const auto mean = mean_energy_of_two(product, beta)) {
      out.gibbs_marginals = {energy_of_two(product, beta)};
      out.gibbs_mean = [product, mean = *mean](std::string_view observable) -> std::optional<reference_value> {
        if (observable != "energy") return std::nullopt;
        return reference_value{mean, 1e-15 * std::fabs(product)};
      };
    }
  }
  out.in_unit = [=](int power) { return in_unit(s, power); };
  out.in_cpp = in_cpp(s);
  out.in_cpp_sized = true;
  return out;
}

parameter_rule strengths_rule() {
  auto rule = vector_of("strengths", 1, "1 / time", "Gamma_i, counterclockwise > 0 seen from outside");
  rule.accepts = fmt::format("1 to {} finite numbers, none of them 0", most_vortices);
  rule.read = [](const number_rows& given, shape s) -> std::optional<number_rows> {
    const bool fits = s == shape::vector && !given[0].empty() && given[0].size() <= std::size_t{most_vortices} &&
                      std::ranges::all_of(given[0], [](double x) { return x != 0; });
    return fits ? std::optional(given) : std::nullopt;
  };
  return rule;
}

bool are_vortices(std::span<const double> mu, const std::vector<double>& strengths) {
  if (mu.size() != 3 * strengths.size()) return false;
  for (std::size_t i = 0; i < strengths.size(); ++i)
    if (!(std::fabs(length(mu.subspan(3 * i, 3)) / std::fabs(strengths[i]) - 1) <= length_tolerance)) return false;
  const auto x = positions(mu, strengths);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (distance(x[i], x[j]) < one_place) return false;
  return true;
}

parameter_rule states_for(const std::vector<double>& strengths) {
  auto rule = vector_of("momentum", 3 * strengths.size(), "1 / time",
                        "initial mu_i = -Gamma_i x_i, one after the other, x_i on the unit sphere");
  rule.accepts = fmt::format("{} finite numbers, |mu_i| = |Gamma_i|, no two vortices in one place",
                             in_words(3 * strengths.size()));
  rule.read = [=](const number_rows& given, shape s) -> std::optional<number_rows> {
    return s == shape::vector && are_vortices(given[0], strengths) ? std::optional(given) : std::nullopt;
  };
  return rule;
}

parameter_rule states_rule() {
  return refined_by([](const report::scene& s) { return states_for(s.vector("strengths")); }, states_for({1}),
                    "3 numbers for each vortex, |mu_i| = |Gamma_i|, no two vortices in one place");
}

parameter_rule noise_rule() {
  const auto noise_of = [](std::size_t count) { return noise_vectors(3 * count, "1 / time^(1/2)"); };
  return refined_by([=](const report::scene& s) { return noise_of(s.vector("strengths").size()); }, noise_of(1),
                    "a finite number, 3 for each vortex, or a list of such vectors");
}

}  // namespace
}  // namespace polhode

POLHODE_FACED_ELSEWHERE(vortices);  // in spins.cpp

namespace polhode {

system_entry vortices_system();

system_entry vortices_system() {
  return {
      .name = "vortices",
      .title = fmt::format("Up to {} dissipative stochastic point vortices on the sphere, on so(3)*^N; N Casimirs",
                           most_vortices),
      .dimension = 0,
      .unit = "1 / time",
      .parameters = {strengths_rule(),
                     dissipation_strength("time", "dissipation: dh/dt = -theta sum |mu_i x Omega_i|^2"), noise_rule()},
      .observables = {{"energy", "h"}},
      .bind = POLHODE_BOUND_TO_SCHEMES(vortices),
      .offers = offers,
      .momentum = states_rule()};
}

}  // namespace polhode
