// SPDX-License-Identifier: Apache-2.0
// The heavy top with its flows inlined into the step.
#pragma once

#include <utility>
#include <vector>

#include <polhode/systems/heavy_top.hpp>

namespace polhode {

struct heavy_top_at : heavy_top {
  heavy_top_at(heavy_top top, const std::vector<double>&, double) : heavy_top(std::move(top)) {}
  static bool fits() { return true; }

  template <class S>
  vec<S, 6> dissipation_flow(const vec<S, 6>& mu, double t) const {
    return damped(mu, t);
  }
  template <class S>
  vec<S, 6> first_turn(const vec<S, 6>& mu, double t) const {
    return fallen(mu, t);
  }
  template <class S>
  vec<S, 6> last_turn(const vec<S, 6>& mu, double t) const {
    return turned(mu, t);
  }
};

}  // namespace polhode
