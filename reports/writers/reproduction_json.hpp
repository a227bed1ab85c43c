// SPDX-License-Identifier: Apache-2.0
// Reproductions as one JSON document.
#pragma once

#include <span>
#include <string>

#include "reports/model/reproduction.hpp"

namespace polhode::report {

inline constexpr std::string_view reproductions_schema_name = "polhode-reproductions";

std::string to_json(std::span<const reproduction>);

}  // namespace polhode::report
