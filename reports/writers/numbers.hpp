// SPDX-License-Identifier: Apache-2.0
// How numbers appear: every digit for machines, four for readers, nothing at all where there is none.
#pragma once

#include <optional>
#include <string>

#include "reports/model/finite.hpp"

namespace polhode::report {

/// The shortest text that reads back as the same number; empty where there is none.
std::string shortest(std::optional<double>);

/// The nearest number of so many significant digits.
double rounded(double, int digits);

/// Rounding to so many digits changes a number by this at most.
double rounding(double, int digits);

/// Four significant digits, "1.234e-5"; a dash where there is none.
std::string shown(std::optional<double>);

/// Three decimals: orders stand below one another.
std::string shown_order(std::optional<double>);

/// "[low, high]"; empty where an end is missing.
std::string shown_interval(std::optional<double> low, std::optional<double> high);
std::string shown_order_interval(std::optional<double> low, std::optional<double> high);

/// Seconds as a reader would say them: "0.42 s", "3 min 12 s", "2 h 5 min".
std::string shown_duration(double seconds);

}  // namespace polhode::report
