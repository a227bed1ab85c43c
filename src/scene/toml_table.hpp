// SPDX-License-Identifier: Apache-2.0
// The text of a TOML file -> its table; what is no TOML is refused in words for somebody who writes a scene.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/scene.hpp"

namespace polhode {

/// `source` names the text in errors. Throws input_error.
toml::table toml_table(std::string_view text, std::string_view source);

// What a node of a TOML file holds; nothing where it holds something else.

std::optional<std::string> text_in(const toml::node&);
/// Finite, written as an integer or not.
std::optional<double> number_in(const toml::node&);
std::optional<std::vector<double>> numbers_in(const toml::node&);
/// In the shape that it has; an empty list is one of vectors.
std::optional<report::parameter> parameter_in(const toml::node&);

/// As a file would say it: each number in the shortest form that reads back as the same.
std::string as_written(const toml::node&);

}  // namespace polhode
