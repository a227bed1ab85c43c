// A scene's rigid body.
#pragma once

#include <vector>

#include <polhode/systems/rigid_body.hpp>

#include "problem/subject.hpp"

namespace polhode {

inline rigid_body make_rigid_body(const report::scene& s) {
  std::vector<rigid_body::column> vectors;
  for (const auto& v : s.sigma) vectors.push_back({v});
  return rigid_body(s.inertia, s.theta, rigid_body::from_vectors(vectors));
}

}  // namespace polhode

// The rigid body bound to every scheme, once per instruction set (isa/rigid_body.cpp).
extern "C" {
void polhode_bind_rigid_body_v2(const polhode::report::scene&, polhode::subject&);
void polhode_bind_rigid_body_v3(const polhode::report::scene&, polhode::subject&);
void polhode_bind_rigid_body_v4(const polhode::report::scene&, polhode::subject&);
void polhode_bind_rigid_body_portable(const polhode::report::scene&, polhode::subject&);
}
