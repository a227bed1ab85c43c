// SPDX-License-Identifier: Apache-2.0
// A scene and its system become what the experiments see.
#pragma once

#include <vector>

#include "foreign/foreign_scheme.hpp"
#include "reports/model/results.hpp"
#include "scene/scene.hpp"
#include "systems/systems.hpp"

namespace polhode {

/// The scene's system with every scheme that applies to it, ours and those from elsewhere. Throws input_error on an
/// unknown system.
subject bind_scene(const scene&, const foreign::foreign_schemes& = {});

/// Throws input_error where a value of its scene, or what follows from all, is so large or so small that double
/// precision and not a scheme would be tried.
void require_scale(const subject&);

/// A scheme and what it claims, as reports say it.
report::scheme described(const scheme_entry&, const foreign::foreign_scheme* = nullptr);
/// All of them, as `polhode list` prints them.
std::vector<report::scheme> list_schemes();

}  // namespace polhode
