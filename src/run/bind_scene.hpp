// A scene and its system become what the experiments see.
#pragma once

#include <vector>

#include "reports/model/results.hpp"
#include "scene/scene.hpp"
#include "systems/systems.hpp"

namespace polhode {

/// The scene's system with every scheme that applies to it. Throws input_error on an unknown system.
subject bind_scene(const scene&);

/// A scheme and what it claims, as reports say it.
report::scheme described(const scheme_entry&);
/// All of them, as `polhode list` prints them.
std::vector<report::scheme> list_schemes();

}  // namespace polhode
