// SPDX-License-Identifier: Apache-2.0
// Cost against error: which points no other beats, and what an accuracy costs. Plain numbers, nothing is measured here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace polhode {

/// A scheme at a step size: its error and what a path costs per unit of time there, each with an interval.
struct cost_point {
  std::string scheme;
  double dt = 0;
  double error = 0, error_low = 0, error_high = 0;
  double cost = 0, cost_low = 0, cost_high = 0;
  bool front = false;

  /// An error lost in its own uncertainty may be small by accident: it beats nothing.
  bool resolved() const { return error > 0 && error_high - error_low <= error; }
};

/// Marks the points that are resolved and that no other resolved one beats: none is as cheap and as accurate, and
/// better in one of the two. By medians and estimates; intervals are for the reader.
void mark_front(std::span<cost_point>);

/// What an accuracy costs with one scheme.
struct reached {
  std::string scheme;
  double dt, cost, low, high;
  bool coarsest = false;  ///< even the coarsest measured level is that accurate: a longer step may do
};

/// Of the points of one scheme: the longest dt from which on down all measured errors are at most `accuracy`, between
/// two measured levels by a power law. An unresolved error counts as the end of its interval. Empty where the finest
/// measured level is not that accurate.
std::optional<reached> reach(std::vector<cost_point> of_scheme, double accuracy);

/// The same for every scheme that reaches it, the cheapest first.
std::vector<reached> ranking(std::span<const cost_point>, double accuracy);

}  // namespace polhode
