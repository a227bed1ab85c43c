// SPDX-License-Identifier: Apache-2.0
// Strengths of the vortices of a scene, and where they are.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "problem/vectors.hpp"
#include "reports/model/scene.hpp"

namespace polhode {

/// Gamma_i: the sign that the scene gives, the size |mu_i|, with which that of the scene agrees but for rounding.
inline std::vector<double> circulations_of(const report::scene& s) {
  auto out = s.vector("strengths");
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::copysign(length(std::span(s.momentum).subspan(3 * i, 3)), out[i]);
  return out;
}

}  // namespace polhode
