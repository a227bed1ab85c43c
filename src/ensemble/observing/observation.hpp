// SPDX-License-Identifier: Apache-2.0
// What is seen of an ensemble when it stops.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ensemble/model.hpp"
#include "ensemble/observing/running_moments.hpp"

namespace polhode {

/// The ensemble at one time. Lost bodies (not finite) are counted and left out of everything else.
struct ensemble_moments {
  running_moments energy;
  std::vector<running_moments> components;
  std::int64_t lost = 0;
  double casimir_change = 0;  ///< the largest, relative to the start
  void merge(const ensemble_moments&);
};

/// Looks at one block after another. Not for two threads at once: it works in its own room.
class ensemble_observer {
 public:
  /// Every body starts on the orbit of that momentum.
  ensemble_observer(const model&, std::span<const double> momentum);

  /// Adds the first `lanes` of a block.
  void observe(std::span<const double> states, int lanes, ensemble_moments&);

  static ensemble_moments nothing(const model&);

 private:
  /// Of the lanes that were found.
  running_moments moments_of(const double* row);

  const model& model_;
  std::vector<double> start_casimirs_;
  double casimir_scale_ = 0;
  std::vector<double> energies_, casimirs_, values_;
  std::vector<int> found_;  ///< lanes that are not lost
};

}  // namespace polhode
