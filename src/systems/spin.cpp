// SPDX-License-Identifier: Apache-2.0
// The spin: its table, what it offers, and its faces.
#if defined(POLHODE_ISA)
#define POLHODE_CALLED  // a face inlines the flows, as it compiles each of them once
#endif
#include <polhode/systems/spin.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>
#include <vector>

#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "references/free_rotation.hpp"
#include "sphere/equilibria.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"
#include "systems/varying_spin.hpp"

namespace polhode {
namespace {

[[maybe_unused]] spin make_spin(const report::scene& s) {
  std::vector<spin::column> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back({{v[0], v[1], v[2]}});
  return {matrix_of(s.vectors("quadratic")), three(s.vector("field")), dissipation_of(s), spin::from_vectors(vectors)};
}

}  // namespace
#if defined(POLHODE_ISA)
template <>
struct faces_for<spin> : kernels_beside<milstein> {};
#endif

}  // namespace polhode

POLHODE_BEHIND_FACES(spin, polhode::make_spin);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

using report::number_rows;
using report::shape;

constexpr double least_anisotropy = 1e-3, greatest_anisotropy = 1e3, next_to_none = 1e-8;

number_rows rows_of_matrix(const Eigen::Matrix3d& m) {
  number_rows out;
  for (Eigen::Index i = 0; i < 3; ++i) out.push_back({m(i, 0), m(i, 1), m(i, 2)});
  return out;
}

sphere_problem on_sphere(const report::scene& s) {
  const auto& field = s.vector("field");
  return with_noise_of(s, {.quadratic = matrix_of(s.vectors("quadratic")),
                           .damping = dissipation_of(s),
                           .radius = length(s.momentum),
                           .covariance = {},
                           .field = Eigen::Vector3d(field.data())});
}

rate_bounds spin_rates(const sphere_problem& p) {
  rate_bounds out;
  out.motion = greatest_rate_on(p);
  out.damping = p.radius * (p.radius * p.spread() + p.field.norm());
  out.dissipation = p.damping * out.damping;
  out.noise = noise_rate(p);
  return out;
}

/// Without a field: the body of inertia 1/(lambda_k + a), a making all of them positive, moves as the spin does.
free_motion free_of(const sphere_problem& p, const report::scene& s) {
  const Eigen::Matrix3d axes = principal_axes(p);
  const Eigen::Vector3d lambda = (axes.transpose() * p.quadratic * axes).diagonal(),
                        start = axes.transpose() * Eigen::Vector3d(s.momentum.data());
  const double unit = p.spread() > 0 ? p.spread() : 1;
  const Eigen::Vector3d inertia = (lambda.array() - lambda.minCoeff() + unit).inverse();
  return {"jacobi", [=](double time) {
            const auto end = free_rotation(three({inertia.data(), 3}), three({start.data(), 3}), time);
            const Eigen::Vector3d there = axes * Eigen::Vector3d(end.data());
            return std::vector<double>{there[0], there[1], there[2]};
          }};
}

/// The same with the differences of the eigenvalues of `quadratic` multiplied.
report::scene with_anisotropy(report::scene s, double factor) {
  const Eigen::Matrix3d q = matrix_of(s.vectors("quadratic"));
  const Eigen::Matrix3d round = q.trace() / 3 * Eigen::Matrix3d::Identity();
  s.vectors("quadratic") = rows_of_matrix(round + factor * (q - round));
  return s;
}

report::scene in_unit(report::scene s, int power) {
  for (double& b : s.vector("field")) b = std::ldexp(b, 2 * power);
  return in_momentum_unit(std::move(s), power);
}

std::string spin_in_cpp(const report::scene& s) {
  const auto& rows = s.vectors("quadratic");
  std::vector<std::string> entries, vectors;
  for (const auto& row : rows) entries.push_back(fmt::format("{}", fmt::join(row, ", ")));
  for (const auto& v : noise_vectors_of(s)) vectors.push_back(fmt::format("{{{{{}}}}}", fmt::join(v, ", ")));
  const std::string list =
      vectors.empty() ? "" : fmt::format("  const vec<double, 3> sigma[] = {{{}}};\n", fmt::join(vectors, ", "));
  return fmt::format(
      "  Eigen::Matrix3d quadratic;\n  quadratic << {};\n{}  const spin body(quadratic, {{{}}}, {}, {});\n",
      fmt::join(entries, ", "), list, fmt::join(s.vector("field"), ", "), dissipation_of(s),
      vectors.empty() ? "spin::isotropic(0)" : "spin::from_vectors(sigma)");
}

capabilities spin_offers(const report::scene& s) {
  const auto p = on_sphere(s);
  capabilities out{.rates = spin_rates(p), .sphere = p};
  if (!p.has_field()) out.free = free_of(p, s);
  if (p.spread() > 0)
    out.shape = {"anisotropy x",          least_anisotropy,
                 greatest_anisotropy,     [=](double factor) { return with_anisotropy(s, factor); },
                 "next to no anisotropy", with_anisotropy(s, next_to_none)};
  out.in_unit = [=](int power) { return in_unit(s, power); };
  out.in_cpp = has_state_noise(s) ? varying_in_cpp(s, p) : spin_in_cpp(s);
  if (has_state_noise(s)) out.in_cpp_header = varying_in_cpp_header;
  out.components = {"pi1", "pi2", "pi3"};
  return out;
}

parameter_rule field_rule(std::string meaning) {
  auto rule = vector_of("field", 3, "1 / time", std::move(meaning));
  rule.fallback = number_rows{{0, 0, 0}};
  return rule;
}

/// E = -S.K S - B.S: a number K is K e_3 e_3^T.
parameter_rule anisotropy_rule() {
  auto rule = symmetric_matrix("anisotropy", 3, "1 / (momentum time)", "K in E = -S.K S - B.S; a number K: along e_3");
  rule.accepts = "a finite number, " + rule.accepts;
  rule.read = [matrix = rule.read](const number_rows& given, shape s) {
    return s == shape::number ? std::optional(number_rows{{0, 0, 0}, {0, 0, 0}, {0, 0, given[0][0]}})
                              : matrix(given, s);
  };
  return rule;
}

/// Landau and Lifshitz's equation dS = -S x (B + noise) - alpha S x (S x B) at temperature k_B T (Brown 1963): h = E,
/// theta = alpha, sigma = sqrt(2 alpha k_B T); noise that is inside the damping, too, is stronger by sqrt(1 + alpha^2
/// |S|^2) in law.
std::vector<report::parameter> from_spin_units(const report::scene& s) {
  const Eigen::Matrix3d quadratic = Eigen::Matrix3d::Zero() - 2 * matrix_of(s.vectors("anisotropy"));
  const double damping = s.number("damping"), inside = has_state_noise(s) ? damping * length(s.momentum) : 0;
  const double sigma = std::sqrt(2 * damping * s.number("temperature") / (1 + inside * inside));
  std::vector<double> field;
  for (const double b : s.vector("field")) field.push_back(0 - b);
  number_rows noise;
  if (sigma > 0) noise = rows_of_matrix(sigma * Eigen::Matrix3d::Identity());
  std::vector<report::parameter> out{{"quadratic", shape::vectors, rows_of_matrix(quadratic)},
                                     {"field", shape::vector, {field}},
                                     {std::string(dissipation_key), shape::number, {{damping}}},
                                     {std::string(noise_key), shape::vectors, noise}};
  if (has_state_noise(s)) out.insert(out.end() - 1, s.at(noise_form_key));
  return out;
}

}  // namespace

system_entry spin_system();

system_entry spin_system() {
  return {
      .name = "spin",
      .title = "Dissipative stochastic spin or gyrostat, any h of degree two on so(3)*, one Casimir |Pi|",
      .dimension = 3,
      .unit = "momentum",
      .parameters = {symmetric_matrix("quadratic", 3, "1 / (momentum time)",
                                      "Lambda in h = Pi.Lambda Pi / 2 + field.Pi, of any signature"),
                     field_rule("b in h = Pi.Lambda Pi / 2 + b.Pi"),
                     dissipation_strength("1 / momentum", "dissipation: dh/dt = -theta |Pi x Omega|^2"),
                     noise_form({"field", damped_noise, "random anisotropy"}), noise_vectors_of_form("1 / time^(1/2)")},
      .observables = named_observables(),
      .bind =
          [](const report::scene& s) {
            return has_state_noise(s) ? bind_varying_spin(s) : POLHODE_BOUND_TO_SCHEMES(spin)(s);
          },
      .offers = spin_offers,
      .own_units = {anisotropy_rule(), field_rule("B in E = -S.K S - B.S"),
                    number_from_zero("damping", "1 / momentum", "alpha in dS = -S x B - alpha S x (S x B)"),
                    number_from_zero("temperature", "momentum / time", "k_B T: the Gibbs law is exp(-E / k_B T)"),
                    noise_form({"field", damped_noise, ""})},
      .from_own_units = from_spin_units};
}

}  // namespace polhode
#endif
