// SPDX-License-Identifier: Apache-2.0
// Numbers that can be drawn and written, how well they are known, and what is said where there is none.
#pragma once

#include <optional>
#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

/// The number, unless it is NaN or infinite.
std::optional<double> finite(std::optional<double>);

/// Half of the interval; of one with an end missing its reach beyond the value; none where there is no interval.
std::optional<double> half_width(const measurement&);

/// Drawn at random: without an interval nobody knows how far from what it estimates.
bool is_sampled(const measurement&);

/// The status; where a number is missing or not finite and the status did not say so, it says so now.
std::string status_of(const measurement&);

/// The reason, likewise.
std::string reason_of(const verdict&);

}  // namespace polhode::report
