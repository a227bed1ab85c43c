// SPDX-License-Identifier: Apache-2.0
// Numbers that can be drawn and written, and what is said where there is none.
#pragma once

#include <optional>
#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

/// The number, unless it is NaN or infinite.
std::optional<double> finite(std::optional<double>);

/// The status; where a number is missing or not finite and the status did not say so, it says so now.
std::string status_of(const measurement&);

/// The reason, likewise.
std::string reason_of(const verdict&);

}  // namespace polhode::report
