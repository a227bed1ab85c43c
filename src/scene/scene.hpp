// SPDX-License-Identifier: Apache-2.0
// A scene: the problem on which schemes are tried. Read from TOML (README.md, "Use") or built in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/model/scene.hpp"

namespace polhode {

using scene = report::scene;

/// The scene of that built-in name, or the file of that path. Throws input_error.
scene load_scene(std::string_view name_or_path);

/// Names of the built-in scenes, in the order in which they are listed.
std::vector<std::string> builtin_scenes();

}  // namespace polhode
