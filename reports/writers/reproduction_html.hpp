// SPDX-License-Identifier: Apache-2.0
// Reproductions as one page that needs nothing else: no network, no script, no other file.
#pragma once

#include <span>
#include <string>

#include "reports/model/reproduction.hpp"

namespace polhode::report {

std::string to_html(std::span<const reproduction>);

}  // namespace polhode::report
