// SPDX-License-Identifier: Apache-2.0
// A comparison as one JSON document.
#pragma once

#include <span>
#include <string>

#include "reports/model/comparison.hpp"

namespace polhode::report {

/// Of one scene an object, of several a list of them.
std::string to_json(std::span<const comparison>);

}  // namespace polhode::report
