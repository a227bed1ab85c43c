// SPDX-License-Identifier: Apache-2.0
// What drives every system beside its energy: dissipation of strength theta, and noise vectors sigma_i.
#pragma once

#include <cmath>
#include <string_view>
#include <utility>

#include "reports/model/scene.hpp"

namespace polhode {

inline constexpr std::string_view dissipation_key = "theta", noise_key = "sigma";

inline double dissipation_of(const report::scene& s) { return s.number(dissipation_key); }
inline const report::number_rows& noise_vectors_of(const report::scene& s) { return s.vectors(noise_key); }

inline report::scene with_dissipation(report::scene s, double strength) {
  s.number(dissipation_key) = strength;
  return s;
}
inline report::scene with_noise_vectors(report::scene s, report::number_rows vectors) {
  s.vectors(noise_key) = std::move(vectors);
  return s;
}
inline report::scene with_noise_times(report::scene s, double factor) {
  for (auto& v : s.vectors(noise_key))
    for (double& x : v) x *= factor;
  return s;
}

/// Pi -> s Pi, theta -> theta / s, sigma -> sqrt(s) sigma, s = 4^power: every factor is a power of two, and no digit is
/// lost. With t -> t / s solutions go over into solutions where h is quadratic.
inline report::scene with_momentum_unit(report::scene s, int power) {
  for (double& x : s.momentum) x = std::ldexp(x, 2 * power);
  const double theta = dissipation_of(s);
  return with_dissipation(with_noise_times(std::move(s), std::ldexp(1.0, power)), std::ldexp(theta, -2 * power));
}

}  // namespace polhode
