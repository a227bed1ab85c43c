// SPDX-License-Identifier: Apache-2.0
// Which noise of the experiment on stability is audited.
//
// Runs of as many steps have the same normals, whatever their scheme and case. So one scheme is heard, and of it the
// search for the stability limit on the scene itself, the first row of the map, and what only effort thorough has;
// beside it the first case whose mean energy is sampled.
#pragma once

#include <string>

#include "experiments/common/noise_verdict.hpp"
#include "experiments/stability/stability_case.hpp"

namespace polhode {

/// Each part by one thread at a time.
class heard_noise {
 public:
  enum part { reference, limit, map, rare_breaks, long_drift };

  explicit heard_noise(const subject&);

  block_listener listener(part);
  /// The same for the scheme that is heard; for others nobody listens.
  block_listener listener(part, const scheme_entry&);

  void report(report::results& out) const { log_.report("stability", out, scheme_); }

 private:
  noise_log log_;
  std::string scheme_;
};

}  // namespace polhode
