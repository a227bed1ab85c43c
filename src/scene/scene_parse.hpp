// SPDX-License-Identifier: Apache-2.0
// The text of a scene -> the checked scene.
#pragma once

#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace polhode {

/// `source` names the text in errors; `default_name` is taken where the text has no name. Throws input_error.
scene parse_scene(std::string_view text, std::string_view source, std::string_view default_name);

}  // namespace polhode
