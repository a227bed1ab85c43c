// SPDX-License-Identifier: Apache-2.0
// What has changed between two results, for a reader: settings first, regressions before the rest.
#pragma once

#include <string>
#include <string_view>

#include "reports/model/comparison.hpp"

namespace polhode::report {

std::string_view heading_of(change_kind);

/// "strong magnus: error of state, dt = 0.125: 1.2e-3 [1.1e-3, 1.3e-3], now 2.4e-3 [2.3e-3, 2.5e-3]".
std::string line_of(const change&);

/// At most `most` lines of each kind.
std::string to_text(const comparison&, std::size_t most = 20);

}  // namespace polhode::report
