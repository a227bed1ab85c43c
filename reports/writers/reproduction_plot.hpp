// SPDX-License-Identifier: Apache-2.0
// A published curve and ours as one SVG element.
#pragma once

#include <string>

#include "reports/model/reproduction.hpp"

namespace polhode::report {

/// The published points as a line, ours as circles; both axes with ticks and names. Empty where no point can be drawn.
/// Colours come from the page: classes `published`, `ours`, `axis`.
std::string to_svg(const reproduced_curve&);

}  // namespace polhode::report
