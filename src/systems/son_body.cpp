// SPDX-License-Identifier: Apache-2.0
// The body in n dimensions: its table, what it offers, and its faces.
#include <polhode/systems/son_body.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "problem/vectors.hpp"
#include "systems/cpp_text.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

[[maybe_unused]] son_body make_son_body(const report::scene& s) {
  return {s.vector("inertia"), dissipation_of(s),
          son_body::from_vectors(noise_vectors_of(s), static_cast<int>(s.momentum.size()))};
}

}  // namespace
}  // namespace polhode

POLHODE_BEHIND_FACES(son_body, polhode::make_son_body);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

using report::number_rows;
using report::shape;

std::size_t components_of_son_body(std::size_t rows) { return rows * (rows - 1) / 2; }

/// The two smallest moments make the least inertia.
rate_bounds son_body_rates(const report::scene& s) {
  auto lambda = s.vector("inertia");
  std::ranges::sort(lambda);
  const double least = lambda[0] + lambda[1], greatest = lambda.back() + lambda[lambda.size() - 2],
               size = length(s.momentum);
  rate_bounds out;
  out.motion = size / least;
  out.damping = size * size * (1 / least - 1 / greatest);
  out.dissipation = dissipation_of(s) * out.damping;
  for (const auto& v : noise_vectors_of(s)) out.noise += std::pow(length(v), 2);
  return out;
}

std::string son_body_in_cpp(const report::scene& s) {
  return fmt::format("{}  const son_body body({}, {}, son_body::from_vectors(sigma, {}));\n", noise_in_cpp(s),
                     list_in_cpp(s.vector("inertia")), dissipation_of(s), s.momentum.size());
}

capabilities son_body_offers(const report::scene& s) {
  capabilities out{.rates = son_body_rates(s)};
  out.in_cpp = son_body_in_cpp(s);
  out.in_cpp_sized = true;
  out.in_unit = [=](int power) { return with_momentum_unit(s, power); };
  out.no_gibbs_mean = "no closed form of the law's means is known here";
  return out;
}

parameter_rule son_body_rows() {
  auto rule = number_of("n", "1", "of so(n)");
  rule.accepts = fmt::format("an integer from 3 to {}", son::most_rows);
  rule.read = [](const number_rows& given, shape s) -> std::optional<number_rows> {
    const auto fits = [](double n) { return n >= 3 && n <= son::most_rows && n == std::floor(n); };
    return s == shape::number && fits(given[0][0]) ? std::optional(given) : std::nullopt;
  };
  return rule;
}

/// lambda_i + lambda_j > 0 for i != j: one of them may be negative, or zero.
parameter_rule moments_for(std::size_t rows) {
  auto rule = vector_of("inertia", rows, "inertia", "lambda_i: the inertia in the plane (i, j) is lambda_i + lambda_j");
  rule.accepts += ", any two of which add up to more than 0";
  rule.read = [rows](const number_rows& given, shape s) -> std::optional<number_rows> {
    if (s != shape::vector || given[0].size() != rows) return std::nullopt;
    auto sorted = given[0];
    std::ranges::sort(sorted);
    return sorted[0] + sorted[1] > 0 ? std::optional(given) : std::nullopt;
  };
  return rule;
}

parameter_rule son_body_states(std::size_t rows) {
  return nonzero_vector_of("momentum", components_of_son_body(rows), "inertia / time",
                           "initial M_12, M_13, …, M_23, …");
}

parameter_rule son_body_noise(std::size_t rows) {
  return noise_vectors(components_of_son_body(rows), "1 / time^(1/2)");
}

}  // namespace

system_entry son_body_system();

system_entry son_body_system() {
  return {
      .name = "son_body",
      .title = "Dissipative stochastic rigid body in n = 3 to 6 dimensions, on so(n)*; n/2 Casimirs",
      .dimension = 0,
      .unit = "inertia / time",
      .parameters = {son_body_rows(), by_rows(moments_for, "n finite numbers, any two of which add up to more than 0"),
                     dissipation_strength("time / inertia", "dissipation: dh/dt = -theta |ad*_Omega mu|^2"),
                     by_rows(son_body_noise, "a finite number, n (n - 1) / 2 of them, or a list of such vectors")},
      .observables = {{"energy", "h"}, {"mu_1", "first component; so for every one"}},
      .bind = POLHODE_BOUND_TO_SCHEMES(son_body),
      .offers = son_body_offers,
      .momentum = by_rows(son_body_states, "n (n - 1) / 2 finite numbers, not all zero")};
}

}  // namespace polhode
#endif
