// SPDX-License-Identifier: Apache-2.0
// The JSON of the values that more than one document holds. Included by writers only.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "reports/model/results.hpp"

namespace polhode::report {

using json = nlohmann::ordered_json;

/// Null where there is no number, or none that is finite.
json number(std::optional<double>);

struct node;

/// On one line, whatever its texts hold.
std::string compact(const json&);

json to_value(const provenance&);
json to_value(const scene&);
json to_value(const scheme&);
provenance provenance_from(const node&);
scene scene_from(const node&);

/// {"name": …, "version": …}, with which every document of ours begins.
json schema_of(std::string_view name, int version);

/// Whether the text begins as a document of that schema does, whatever blanks stand between.
bool begins_with_schema(std::string_view text, std::string_view name);

}  // namespace polhode::report
