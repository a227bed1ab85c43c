// SPDX-License-Identifier: Apache-2.0
// The text of a TOML file -> its table; what is no TOML is refused in words for somebody who writes a scene.
#pragma once

#include <toml++/toml.h>

#include <string_view>

namespace polhode {

/// `source` names the text in errors. Throws input_error.
toml::table toml_table(std::string_view text, std::string_view source);

}  // namespace polhode
