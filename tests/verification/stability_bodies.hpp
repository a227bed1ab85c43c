// SPDX-License-Identifier: Apache-2.0
// Bodies whose limits of stability are known.
#pragma once

#include <utility>

#include "scene/scene.hpp"

namespace polhode::test {

/// No free rotation, no dissipation: the noise alone moves it.
inline scene spherical(report::number_rows sigma) {
  auto s = load_scene("paper");
  s.vector("inertia") = {1, 1, 1};
  s.number("theta") = 0;
  s.vectors("sigma") = std::move(sigma);
  return s;
}

}  // namespace polhode::test
