// SPDX-License-Identifier: Apache-2.0
// A scene's rigid body.
#pragma once

#include <vector>

#include <polhode/systems/rigid_body.hpp>

#include "problem/subject.hpp"
#include "problem/vectors.hpp"

namespace polhode {

inline rigid_body make_rigid_body(const report::scene& s) {
  std::vector<rigid_body::column> vectors;
  for (const auto& v : noise_vectors_of(s)) vectors.push_back({{v[0], v[1], v[2]}});
  return rigid_body(three(s.vector("inertia")), dissipation_of(s), rigid_body::from_vectors(vectors));
}

}  // namespace polhode
