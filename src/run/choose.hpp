// SPDX-License-Identifier: Apache-2.0
// The choice of an integrator for a scene: what the command select calls.
#pragma once

#include <string>
#include <vector>

#include "foreign/foreign_scheme.hpp"
#include "scene/scene.hpp"
#include "selection/select.hpp"

namespace polhode {

struct select_options {
  std::string goal;
  double tolerance = 0;
  std::string observable = "all";    ///< of weak and stationary: the worst of all, or one; see system_entry
  std::optional<double> time;        ///< the scene's horizon if absent
  std::vector<std::string> require;  ///< see requirements()
  int threads = 1;
  std::uint64_t seed = 1;
  std::string isa = "auto";
  foreign::foreign_schemes foreign = {};  ///< integrators from elsewhere, beside ours
};

/// Throws input_error on what cannot be asked of the scene.
selection select(const scene&, const select_options&);

}  // namespace polhode
