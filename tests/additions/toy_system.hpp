// SPDX-License-Identifier: Apache-2.0
// A top whose energy is quartic, h = k Pi_3^4 / 4, to be added to a copy of the tree.
#pragma once

#include <utility>

#include <polhode/lie/so3.hpp>
#include <polhode/systems/double_bracket.hpp>

namespace polhode {

struct toy_system : double_bracket<toy_system, so3> {
  toy_system(double stiffness, double dissipation, constant_noise<so3> vectors)
      : double_bracket(dissipation, std::move(vectors)), k(stiffness) {}

  double k;

  template <class S>
  vec<S, 3> omega(const vec<S, 3>& pi) const {
    return {{S(0.0), S(0.0), S(S(k) * (pi[2] * pi[2])) * pi[2]}};
  }
  template <class S>
  S energy(const vec<S, 3>& pi) const {
    return S(0.25 * k) * (pi[2] * pi[2]) * (pi[2] * pi[2]);
  }
};

}  // namespace polhode
