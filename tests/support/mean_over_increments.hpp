// SPDX-License-Identifier: Apache-2.0
// Means over the increments of one step that are not sampled.
#pragma once

#include <cmath>
#include <vector>

#include <polhode/increment.hpp>

namespace polhode::test {

/// E f(increments of variance dt, areas zero) by Gauss and Hermite's rule of four nodes for each of the channels that
/// act, exact to the seventh power of each increment.
template <int M, class F>
double mean_over_increments(double dt, const std::vector<int>& acting, const F& f) {
  const double inner = std::sqrt(3 - std::sqrt(6.0)), outer = std::sqrt(3 + std::sqrt(6.0));
  const double nodes[] = {-outer, -inner, inner, outer};
  const double heavy = (3 + std::sqrt(6.0)) / 12, light = (3 - std::sqrt(6.0)) / 12;
  const double weights[] = {light, heavy, heavy, light};
  double mean = 0;
  for (int which = 0; which < 1 << (2 * acting.size()); ++which) {
    wiener_levy<double, M> w;
    w.dt = dt;
    double weight = 1;
    for (std::size_t i = 0; i < acting.size(); ++i) {
      const int node = which >> (2 * i) & 3;
      w.dw[acting[i]] = std::sqrt(dt) * nodes[node];
      weight *= weights[node];
    }
    mean += weight * f(w);
  }
  return mean;
}

}  // namespace polhode::test
