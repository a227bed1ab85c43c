// SPDX-License-Identifier: Apache-2.0
// What the experiments see of a scene: a system and its schemes, as plain values and virtual faces.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <polhode/schemes/scheme_info.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/model.hpp"
#include "ensemble/tangent_kernel.hpp"
#include "problem/capabilities.hpp"
#include "problem/drives.hpp"
#include "reports/model/scene.hpp"
#include "reports/model/work.hpp"

namespace polhode {

struct scheme_entry {
  scheme_info info;
  bool needs_areas = false;
  std::function<std::unique_ptr<kernel>(double dt)> make;
  std::function<std::unique_ptr<tangent_kernel>(double dt)> tangent;  ///< the same step with its derivative
};

/// Whether any of them asks for Levy areas; where none does they are not drawn.
inline bool any_needs_areas(std::span<const scheme_entry> schemes) {
  return std::ranges::any_of(schemes, &scheme_entry::needs_areas);
}

/// A scene bound to its system and to every scheme that applies to it.
struct subject {
  report::scene scene;
  std::shared_ptr<const polhode::model> model;
  std::shared_ptr<const capabilities> offers;
  std::vector<scheme_entry> schemes;
  std::vector<report::skip> inapplicable;             ///< schemes that cannot run on this system, and why
  std::function<subject(const report::scene&)> with;  ///< the same system and schemes on a changed scene

  subject without_noise() const { return with(with_noise_vectors(scene, {})); }
  subject without_dissipation() const { return with(with_dissipation(scene, 0)); }

  /// Nothing where the diffusion does not live on a sphere.
  const std::optional<sphere_problem>& sphere() const { return offers->sphere; }
};

/// Claimed strong order on this noise.
inline double strong_order_on(const scheme_info& info, noise_class noise) {
  return noise == noise_class::one_vector ? info.strong_order.commuting : info.strong_order.general;
}

}  // namespace polhode
