// The border of stability by bisection in the number of steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace polhode {

/// Numbers of steps to the horizon, least < start < most: where the search begins and where it gives up.
struct step_range {
  std::int64_t least, start, most;
};

/// The fewest steps that are stable and the most below them that are not; 0: none was found.
struct stability_border {
  std::int64_t stable = 0, broken = 0;
};

/// stable(n): whether n steps are. From `start` by octaves: towards fewer steps until one breaks, or towards more until
/// one does not; then by halves of log n to 5 %. What lies beyond the first octave that breaks is not asked, so a
/// longer step that is stable by accident does not count.
template <class Stable>
stability_border find_border(const step_range& range, const Stable& stable) {
  constexpr double accuracy = 0.05;
  stability_border out;
  if (stable(range.start)) {
    out.stable = range.start;
    while (out.stable > range.least && out.broken == 0) {
      const auto fewer = std::max(range.least, out.stable / 2);
      (stable(fewer) ? out.stable : out.broken) = fewer;
    }
  } else {
    out.broken = range.start;
    while (out.broken < range.most && out.stable == 0) {
      const auto more = std::min(range.most, 2 * out.broken);
      (stable(more) ? out.stable : out.broken) = more;
    }
  }
  if (out.stable == 0 || out.broken == 0) return out;
  while (out.stable - out.broken > 1 &&
         static_cast<double>(out.stable) > (1 + accuracy) * static_cast<double>(out.broken)) {
    const auto middle = std::llround(std::sqrt(static_cast<double>(out.stable) * static_cast<double>(out.broken)));
    const auto n = std::clamp<std::int64_t>(middle, out.broken + 1, out.stable - 1);
    (stable(n) ? out.stable : out.broken) = n;
  }
  return out;
}

}  // namespace polhode
