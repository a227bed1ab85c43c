// A scene's rigid body.
#pragma once

#include <vector>

#include <polhode/systems/rigid_body.hpp>

#include "problem/subject.hpp"

namespace polhode {

inline rigid_body make_rigid_body(const report::scene& s) {
  std::vector<rigid_body::column> vectors;
  for (const auto& v : s.vectors("sigma")) vectors.push_back({{v[0], v[1], v[2]}});
  const auto& inertia = s.vector("inertia");
  return rigid_body({inertia[0], inertia[1], inertia[2]}, s.number("theta"), rigid_body::from_vectors(vectors));
}

}  // namespace polhode

// The rigid body bound to every scheme, once per instruction set (isa/rigid_body.cpp).
extern "C" {
void polhode_bind_rigid_body_v2(const polhode::report::scene&, polhode::subject&);
void polhode_bind_rigid_body_v3(const polhode::report::scene&, polhode::subject&);
void polhode_bind_rigid_body_v4(const polhode::report::scene&, polhode::subject&);
void polhode_bind_rigid_body_portable(const polhode::report::scene&, polhode::subject&);
}
