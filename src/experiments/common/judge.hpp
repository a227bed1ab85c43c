// SPDX-License-Identifier: Apache-2.0
// Verdicts: the interval of an estimate against a claim, never a point against a tolerance.
#pragma once

#include <optional>
#include <string>

#include "reports/model/results.hpp"
#include "statistics/orders/order_fit.hpp"
#include "statistics/sample.hpp"

namespace polhode {

/// How far an order may lie from its claim.
inline constexpr double order_margin = 0.1;

/// The half-width at which the interval of an order is tight enough to decide.
inline constexpr double tight_order = order_margin / 5;

/// Of anything with an interval [low, high].
double half_width(const auto& estimate) { return (estimate.high - estimate.low) / 2; }

/// Holds if [low, high] lies inside expected +- margin, refuted if disjoint from it, else inconclusive.
report::verdict_kind judge(double expected, double low, double high, double margin);

/// Verdict on an order, or what is measured of one that is not claimed (expected: NaN); a recorder says of what
/// (recorder.hpp). `at_least`: faster than claimed holds
/// too (a scene can be kinder than the claim) once the slope is asymptotic: before a zero crossing it is steep for a
/// while, and nothing is concluded. Refuted where the slope is asymptotic and the two finest levels refute it too, or
/// where they lie no nearer to the claim than the slope does; a slope that still nears the claim is inconclusive.
report::verdict judge_order(double expected, const std::optional<order_fit>&, bool at_least);

/// The same of a sampled order, which decides nothing where it is uncertain by more than the margin, and refutes where
/// it lies beyond the margin by `family_z` of its standard errors: of 95 % intervals one in some thousand lies apart by
/// chance.
report::verdict judge_sampled_order(double expected, const std::optional<order_fit>&);

/// Verdict on a distance that should vanish: holds below `bound`, refuted above it.
report::verdict judge_distance(const interval_estimate&, double bound, const std::string& reason);

}  // namespace polhode
