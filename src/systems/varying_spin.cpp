// SPDX-License-Identifier: Apache-2.0
// Systems on a sphere whose noise depends on the state: the key that says so, and their faces.
#if defined(POLHODE_ISA)
#define POLHODE_CALLED  // a face inlines the flows, as it compiles each of them once
#endif
#include "systems/varying_spin.hpp"

#include <polhode/systems/varying_spin.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "systems/cpp_text.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

/// Of a scene whose noise depends on the state.
state_noise form_of(const report::scene& s) {
  return s.word(noise_form_key) == damped_noise ? state_noise::damped : state_noise::quadratic;
}

/// Any system on a sphere is a spin.
[[maybe_unused]] varying_spin make_varying_spin(const report::scene& s) {
  const auto p = *find_system(s.system)->offers(s).sphere;
  std::vector<spin::column> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back({{v[0], v[1], v[2]}});
  return {spin(p.quadratic, three({p.field.data(), 3}), p.damping, spin::from_vectors(vectors)), form_of(s)};
}

}  // namespace
#if defined(POLHODE_ISA)
template <>
struct faces_for<varying_spin> : kernels_beside<implicit_midpoint, isospectral_midpoint> {};
#endif

}  // namespace polhode

POLHODE_BEHIND_FACES(varying_spin, polhode::make_varying_spin);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

/// v + theta Pi x v, or v (v.Pi)/|v|.
affine_noise varying(const Eigen::Vector3d& v, state_noise form, double theta) {
  if (form == state_noise::quadratic) return {Eigen::Vector3d::Zero(), v * v.transpose() / v.norm()};
  Eigen::Matrix3d across;  // Pi -> Pi x v
  across << 0, v[2], -v[1], -v[2], 0, v[0], v[1], -v[0], 0;
  return {v, theta * across};
}

}  // namespace

parameter_rule noise_form(const noise_forms& names) {
  std::vector<std::string> words{names.constant};
  if (!names.damped.empty()) words.push_back(names.damped);
  if (!names.quadratic.empty()) words.push_back(names.quadratic);
  std::string meaning = "sigma_i(Pi) of the vectors v_i of sigma: v_i";
  if (!names.damped.empty()) meaning += "; v_i + theta Pi x v_i";
  if (!names.quadratic.empty()) meaning += "; v_i (v_i.Pi)/|v_i|";
  return one_of(noise_form_key, std::move(words), meaning);
}

parameter_rule noise_vectors_of_form(std::string unit) {
  auto rule = noise_vectors(3, unit);
  rule.refined = [unit](const report::scene& s) {
    auto of_form = noise_vectors(3, unit);
    if (!has_state_noise(s)) return of_form;
    of_form.accepts = "a finite number, three of them, or a list of at most three vectors of three (as noise = \"" +
                      std::string(s.word(noise_form_key)) + "\")";
    of_form.read = [any = of_form.read](const report::number_rows& given, report::shape shape) {
      auto vectors = any(given, shape);
      return vectors && vectors->size() <= 3 ? vectors : std::nullopt;
    };
    return of_form;
  };
  return rule;
}

bool has_state_noise(const report::scene& s) { return !s.word(noise_form_key).empty(); }

sphere_problem with_noise_of(const report::scene& s, sphere_problem p) {
  p.covariance = Eigen::Matrix3d::Zero();
  if (!has_state_noise(s)) {
    p.covariance = noise_covariance(s);
  } else {
    for (const auto& v : noise_vectors_of(s))
      p.varying.push_back(varying(Eigen::Vector3d(v.data()), form_of(s), p.damping));
  }
  return p;
}

report::scene in_momentum_unit(report::scene s, int power) {
  const bool quadratic = has_state_noise(s) && form_of(s) == state_noise::quadratic;
  s = with_momentum_unit(std::move(s), power);
  return quadratic ? with_noise_times(std::move(s), std::ldexp(1.0, -2 * power)) : s;
}

std::string varying_in_cpp(const report::scene& s, const sphere_problem& p) {
  std::vector<std::string> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back(fmt::format("{{{}}}", list_in_cpp(v)));
  const Eigen::Matrix3d& q = p.quadratic;
  return fmt::format(
      "  Eigen::Matrix3d quadratic;\n  quadratic << {};\n  const std::vector<vec<double, 3>> sigma{{{}}};\n"
      "  const varying_spin body(spin(quadratic, {}, {}, spin::from_vectors(sigma)), state_noise::{});\n",
      fmt::join(q.data(), q.data() + q.size(), ", "), fmt::join(vectors, ", "),
      list_in_cpp({p.field.data(), p.field.data() + 3}), p.damping,
      form_of(s) == state_noise::damped ? "damped" : "quadratic");
}

subject bind_varying_spin(const report::scene& s) { return POLHODE_BOUND_TO_SCHEMES(varying_spin)(s); }

}  // namespace polhode
#endif
