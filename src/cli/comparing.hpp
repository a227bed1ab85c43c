// SPDX-License-Identifier: Apache-2.0
// What a comparison ends with.
#pragma once

#include <span>

#include "reports/model/comparison.hpp"

namespace polhode::cli {

/// 1 if something is worse, else 3 if a claim is no longer shown to hold, else 0.
int exit_code(std::span<const report::comparison>);

}  // namespace polhode::cli
