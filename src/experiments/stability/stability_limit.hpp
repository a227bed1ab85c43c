// SPDX-License-Identifier: Apache-2.0
// The stability limit by bisection in the number of steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/stability/breakage.hpp"

namespace polhode {

/// Numbers of steps to the horizon, least < start < most: where the search begins and where it gives up.
struct step_range {
  std::int64_t least, start, most;
};

/// The fewest steps that are stable and the most below them that are not; 0: none was found.
struct stability_limit {
  std::int64_t stable = 0, broken = 0;
};

/// What one scheme does in one case.
struct finding {
  stability_limit limit;
  breakage first = breakage::none;                          ///< at the shortest step that breaks
  double worst_casimir = 0, worst_energy = 0;               ///< of all runs
  std::vector<std::pair<std::int64_t, double>> whole = {};  ///< of each stable run its steps and worst Casimir

  /// The worst Casimir of the runs up to half the largest stable dt; if there is none, of that itself; nothing where no
  /// run is stable.
  std::optional<double> worst_well_within() const {
    std::optional<double> worst, at_limit;
    for (const auto& [steps, casimir] : whole) {
      if (steps == limit.stable) at_limit = casimir;
      if (steps >= 2 * limit.stable) worst = std::max(worst.value_or(0), casimir);
    }
    return worst ? worst : at_limit;
  }
};

/// Asks one number of steps after the other whether it is stable, so that many searches can go on side by side. From
/// `start` by octaves: towards fewer steps until one breaks, or towards more until one does not; then by halves of
/// log n to 5 %. What lies beyond the first octave that breaks is not asked, so a longer step that is stable by
/// accident does not count.
class limit_search {
 public:
  explicit limit_search(const step_range& range) : range_(range), asks_(range.start) {}

  /// Nothing: the limit is found, or there is none.
  std::optional<std::int64_t> asks() const { return asks_; }
  /// The answer to what it asks.
  void tell(bool stable) {
    (stable ? limit_.stable : limit_.broken) = *asks_;
    asks_ = next();
  }
  const stability_limit& limit() const { return limit_; }

 private:
  std::optional<std::int64_t> next() const {
    constexpr double accuracy = 0.05;
    const auto [stable, broken] = limit_;
    if (broken == 0) return stable > range_.least ? std::optional(std::max(range_.least, stable / 2)) : std::nullopt;
    if (stable == 0) return broken < range_.most ? std::optional(std::min(range_.most, 2 * broken)) : std::nullopt;
    const auto fewer = static_cast<double>(broken), more = static_cast<double>(stable);
    if (stable - broken <= 1 || more <= (1 + accuracy) * fewer) return std::nullopt;
    return std::clamp<std::int64_t>(std::llround(std::sqrt(more * fewer)), broken + 1, stable - 1);
  }

  step_range range_;
  std::optional<std::int64_t> asks_;
  stability_limit limit_;
};

}  // namespace polhode
