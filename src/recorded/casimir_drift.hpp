// SPDX-License-Identifier: Apache-2.0
// How far recorded states are from the coadjoint orbit on which their path began.
#pragma once

#include <vector>

#include "ensemble/model.hpp"
#include "experiments/common/recorder.hpp"
#include "recorded/transitions.hpp"

namespace polhode {

class casimir_drift {
 public:
  explicit casimir_drift(const model&);

  void add(const recorded_transition&);
  /// resolution: of a number of the file, relative. What so many digits hide is no drift.
  void report(double resolution, recorder&) const;

 private:
  const model& model_;
  std::vector<double> largest_;  ///< change over size, of each Casimir
  std::vector<double> sum_;      ///< of the changes, of each: a drift has a sign
  double count_ = 0;
};

}  // namespace polhode
