// SPDX-License-Identifier: Apache-2.0
// A scene that a command was given.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace polhode::cli {

/// As load_scene; what its system has to say about it goes to standard error, one line.
scene opened_scene(const std::string& name_or_path);

}  // namespace polhode::cli
