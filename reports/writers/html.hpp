// SPDX-License-Identifier: Apache-2.0
// The report as one page that needs nothing else: no network, no other file. The page is built by reports/viewer.
#pragma once

#include <string>

#include "reports/model/comparison.hpp"
#include "reports/model/results.hpp"

namespace polhode::report {

/// The template with results.json, packed, and the scene's name in it.
std::string to_html(const results&);

/// The same page of `after`, with `before` behind its plots and what has changed in front of all else.
std::string to_html(const results& before, const results& after, const comparison&);

}  // namespace polhode::report
