// SPDX-License-Identifier: Apache-2.0
// Scenes and increments that reach every specialisation of a kernel.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "scene/scene.hpp"

namespace polhode::test {

using triple = std::vector<double>;

inline report::scene with_parts(triple inertia, double theta, std::vector<triple> sigma) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = inertia;
  scene.number("theta") = theta;
  scene.vectors("sigma") = std::move(sigma);
  return scene;
}

inline const std::vector<triple> isotropic{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}},
    diagonal{{0.2, 0, 0}, {0, 0.5, 0}, {0, 0, 0.7}}, skew{{0.3, 0.1, 0}, {-0.2, 0.4, 0.1}, {0, 0.3, 0.2}},
    one{{0.1, 0.2, 0.3}}, none{};

/// Every specialisation of a kernel: parts of the motion, numbering of the axes, form of the noise.
inline std::vector<report::scene> every_part() {
  return {with_parts({1, 2, 3}, 0.5, isotropic), with_parts({1, 2, 3}, 0, diagonal),
          with_parts({1, 2, 3}, 0.5, skew),      with_parts({2, 1, 1}, 0.5, diagonal),
          with_parts({1, 2, 1}, 0.5, skew),      with_parts({1, 1, 2}, 0.5, isotropic),
          with_parts({1, 1, 2}, 0, skew),        with_parts({2, 2, 2}, 0.5, diagonal),
          with_parts({1, 2, 3}, 0.5, one),       with_parts({1, 2, 3}, 0.5, none),
          with_parts({3, 1, 1}, 0, none)};
}

/// Increments of a block with areas; empty where there is no noise.
struct increments {
  double dt;
  std::vector<double> dw, area;
  increment_view view;
  increments(const model& m, int steps, double step) : dt(step) {
    increment_buffer buffer(m, steps, true);
    if (m.layout().silent()) {
      view = silence(steps);
      return;
    }
    const auto filled = buffer.fill(3, 0, 0, steps, dt);
    dw.assign(filled.dw.begin(), filled.dw.end());
    area.assign(filled.area.begin(), filled.area.end());
    view = {steps, dw, area};
  }
  wiener_levy<double, 3> at(int step, int lane) const {
    wiener_levy<double, 3> w;
    w.dt = dt;
    for (int k = 0; k < 3 && !dw.empty(); ++k) {
      const auto i = static_cast<std::size_t>((step * 3 + k) * block_lanes + lane);
      w.dw[k] = dw[i];
      w.area[k] = area[i];
    }
    return w;
  }
  increment_view step(int i) const {
    if (dw.empty()) return silence(1);
    const auto size = std::size_t{3} * block_lanes, from = static_cast<std::size_t>(i) * size;
    return {1, std::span(dw).subspan(from, size), std::span(area).subspan(from, size)};
  }
};

}  // namespace polhode::test
