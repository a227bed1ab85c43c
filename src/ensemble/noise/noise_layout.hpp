// SPDX-License-Identifier: Apache-2.0
// How the noise of a system is laid out, wherever it is drawn, kept or counted.
#pragma once

#include <cstddef>
#include <cstdint>

#include <polhode/increment.hpp>

namespace polhode {

/// Increments are [step][channel][lane], Levy areas [step][pair i < j][lane] in the order of polhode/increment.hpp; a
/// single path has one lane.
struct noise_layout {
  int channels = 0;
  int active = 0;  ///< the first of them, which are drawn: none, one, or all; the others stay zero

  bool silent() const { return active == 0; }
  int pairs() const { return pairs_among(channels); }
  /// One channel has no area: its pairs stay zero.
  int active_pairs() const { return active > 1 ? pairs() : 0; }

  /// Numbers drawn for a path and step.
  int drawn(bool with_areas) const { return active + (with_areas ? active_pairs() : 0); }

  // Numbers kept.
  std::size_t increments(std::int64_t steps, int lanes = 1) const { return size(steps, channels, lanes); }
  std::size_t areas(std::int64_t steps, int lanes = 1) const { return size(steps, pairs(), lanes); }

 private:
  static std::size_t size(std::int64_t steps, int rows, int lanes) {
    return static_cast<std::size_t>(steps * rows * lanes);
  }
};

}  // namespace polhode
