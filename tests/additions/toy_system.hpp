// A top whose energy is quartic, h = k Pi_3^4 / 4, to be added to a copy of the tree.
#pragma once

#include <utility>

#include <polhode/lie/so3.hpp>
#include <polhode/systems/constant_noise.hpp>
#include <polhode/systems/lie_poisson.hpp>

namespace polhode {

struct toy_system : constant_noise<so3> {
  using algebra = so3;
  toy_system(double stiffness, double dissipation, constant_noise<so3> vectors)
      : constant_noise(std::move(vectors)), k(stiffness), theta(dissipation) {}

  double k, theta;

  template <class S>
  vec<S, 3> omega(const vec<S, 3>& pi) const {
    return {{S(0.0), S(0.0), S(S(k) * (pi[2] * pi[2])) * pi[2]}};
  }
  template <class S>
  S energy(const vec<S, 3>& pi) const {
    return S(0.25 * k) * (pi[2] * pi[2]) * (pi[2] * pi[2]);
  }
  template <class S>
  S dissipation_rate(const vec<S, 3>& pi) const {
    const auto c = cross(pi, omega(pi));
    return S(theta) * dot(c, c);
  }
  template <class S>
  vec<S, 3> generator(const vec<S, 3>& pi) const {
    const auto w = omega(pi);
    return w + S(theta) * cross(pi, w);
  }
  toy_system with_noise(constant_noise<so3> other) const { return {k, theta, std::move(other)}; }
};

}  // namespace polhode
