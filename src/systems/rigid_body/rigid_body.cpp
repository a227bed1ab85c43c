// SPDX-License-Identifier: Apache-2.0
#include "systems/rigid_body/rigid_body.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "references/free_rotation.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"
#include "systems/varying_spin.hpp"

POLHODE_FACED_ELSEWHERE(rigid_body);  // in isa/rigid_body.cpp

namespace polhode {
namespace {

constexpr double greatest_ratio = 1e6;

std::array<double, 3> inertia_of(const report::scene& s) { return three(s.vector("inertia")); }

rate_bounds rates_of(const report::scene& s, const sphere_problem& on_sphere) {
  const double c = length(s.momentum), square = c * c;
  const auto [least, greatest] = std::ranges::minmax(s.vector("inertia"));
  rate_bounds out;
  out.motion = c / least;
  out.damping = square * (1 / least - 1 / greatest);
  out.dissipation = dissipation_of(s) * out.damping;
  out.noise = noise_rate(on_sphere);
  return out;
}

/// The same smallest inertia and, where there is one, the same place of the middle one between the two others.
report::scene with_ratio(report::scene s, double ratio) {
  auto& inertia = s.vector("inertia");
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::ranges::sort(axis, {}, [&](std::size_t k) { return inertia[k]; });
  const double own = inertia[axis[2]] / inertia[axis[0]];
  const double place = own > 1 ? std::log(inertia[axis[1]] / inertia[axis[0]]) / std::log(own) : 0.5;
  inertia[axis[1]] = inertia[axis[0]] * std::pow(ratio, place);
  inertia[axis[2]] = inertia[axis[0]] * ratio;
  return s;
}

std::string in_cpp(const report::scene& s) {
  std::vector<std::string> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back(fmt::format("{{{{{}}}}}", fmt::join(v, ", ")));
  const std::string head =
      fmt::format("  const rigid_body body({{{}}}, {}, ", fmt::join(s.vector("inertia"), ", "), dissipation_of(s));
  if (vectors.empty()) return head + "rigid_body::isotropic(0));\n";
  return fmt::format("  const vec<double, 3> sigma[] = {{{}}};\n{}rigid_body::from_vectors(sigma));\n",
                     fmt::join(vectors, ", "), head);
}

/// Of a mass distribution each moment is at most the sum of the two others; the equation asks for no such thing.
std::string notice_of(std::array<double, 3> inertia) {
  std::ranges::sort(inertia);
  if (inertia[2] <= (inertia[0] + inertia[1]) * (1 + 1e-12)) return "";
  return fmt::format("inertia {:g} > {:g} + {:g}: no rigid body has such moments, but the equation takes them",
                     inertia[2], inertia[0], inertia[1]);
}

capabilities offers(const report::scene& s) {
  const auto inertia = inertia_of(s), start = three(s.momentum);
  const double c = length(s.momentum), theta = dissipation_of(s);
  const auto q = noise_covariance(s);
  const auto on_sphere = with_noise_of(s, body_on_sphere(inertia, theta, c, q));
  capabilities out{.rates = rates_of(s, on_sphere), .notice = notice_of(inertia), .sphere = on_sphere};
  out.free = {"jacobi", [=](double time) {
                const auto end = free_rotation(inertia, start, time);
                return std::vector(end.begin(), end.end());
              }};
  out.shape = {"inertia ratio",       1,
               greatest_ratio,        [=](double ratio) { return with_ratio(s, ratio); },
               "near-equal inertias", with_ratio(s, 1 + 1e-8)};
  out.in_unit = [=](int power) { return in_momentum_unit(s, power); };
  out.in_cpp = has_state_noise(s) ? varying_in_cpp(s, on_sphere) : in_cpp(s);
  if (has_state_noise(s)) out.in_cpp_header = varying_in_cpp_header;
  out.components = {"pi1", "pi2", "pi3"};
  out.gibbs = [=] { return gibbs_law(inertia, c, 2 * theta / q(0, 0)); };
  return out;
}

subject bind_to_schemes(const report::scene& scene) {
  if (has_state_noise(scene)) return bind_varying_spin(scene);
  return POLHODE_BOUND_TO_SCHEMES(rigid_body)(scene);
}

}  // namespace

system_entry rigid_body_system();

system_entry rigid_body_system() {
  return {.name = "rigid_body",
          .title = "Dissipative stochastic rigid body on so(3)*, one Casimir |Pi|",
          .dimension = 3,
          .unit = "inertia / time",
          .parameters = {positive_vector_of("inertia", 3, "inertia", "principal moments of inertia"),
                         dissipation_strength("time / inertia", "dissipation: dh/dt = -theta |Pi x Omega|^2"),
                         noise_form({"constant", "", "random inertia"}), noise_vectors_of_form("1 / time^(1/2)")},
          .observables = named_observables(),
          .bind = bind_to_schemes,
          .offers = offers};
}

}  // namespace polhode
