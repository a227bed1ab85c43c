// SPDX-License-Identifier: Apache-2.0
// A result in short: what a later run is held against and a table of schemes is made from, small enough to stand among
// sources, one scheme a line.
//
//   verdicts   for each claim, by verdict: {scheme: [expected, estimate, low, high, reason]}; the reason of what is
//              refuted or inconclusive
//   errors     for each series with a fit: {scheme: [order, half of its interval, abscissa, error, uncertainty]}; the
//              error at the last level that the fit uses
//   figures    other numbers that describe a scheme, at one level: {scheme: [abscissa, value, low, high, status]}
//   timings    by scheme: ns a path and step, and for each kind of error ns a path and unit of time to reach accuracies
//
// Errors and verdicts have four digits, and errors none below a hundredth of their interval; figures have six. The
// uncertainty of an error is half of its 95 % interval and what rounding has changed. Where there is no interval a
// number is known to half a unit of its last digit, but a sampled one is of unknown noise. An interval without width is
// left out of a verdict. A list ends at its last entry that is not null.
#pragma once

#include <string>

#include "reports/model/results.hpp"

namespace polhode::report {

inline constexpr std::string_view digest_schema_name = "polhode-digest";
inline constexpr int digest_schema_version = 1, error_digits = 4, figure_digits = 6;

std::string to_digest(const results&);

struct node;

/// What a digest holds of its result, without the timings. Throws input_error, on one line.
results digest_from(const node&);

}  // namespace polhode::report
