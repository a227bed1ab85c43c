// SPDX-License-Identifier: Apache-2.0
// The scenes of reports/scenes, embedded at build time.
#pragma once

#include <span>
#include <string_view>

namespace polhode {

struct builtin_scene {
  std::string_view name, title, text;  ///< title: the first comment line of the text
};

/// All of them, `paper` first. The definition is generated (cmake/polhode_scenes.cmake).
std::span<const builtin_scene> builtin_scene_table();

}  // namespace polhode
