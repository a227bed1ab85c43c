// SPDX-License-Identifier: Apache-2.0
// The page that reports/viewer builds, in pieces, with the places that html.cpp fills.
#pragma once

#include <span>
#include <string_view>

namespace polhode::report {

inline constexpr std::string_view title_place = "@polhode-title@", results_place = "@polhode-results@",
                                  before_place = "@polhode-before@", comparison_place = "@polhode-comparison@";

std::span<const std::string_view> page_template();

}  // namespace polhode::report
