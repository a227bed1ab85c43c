// SPDX-License-Identifier: Apache-2.0
// What a run costs: time on the wall and of the processor, and what the processor worked on.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "platform/cpu_profile.hpp"
#include "reports/model/results.hpp"

namespace polhode {

/// Of this process, all threads together.
double cpu_seconds();

/// Of this run, up to now.
class stopwatch {
 public:
  void read(report::provenance&) const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double cpu_start_ = cpu_seconds();
};

/// Of one experiment after the other, if it is asked for.
class experiment_profile {
 public:
  explicit experiment_profile(bool wanted);
  void begin();
  /// What no thread had a name for is what is left of the whole.
  void end(const std::string& experiment, std::vector<report::profile_row>& out);

 private:
  std::optional<cpu_profile> profile_;
  double cpu_start_ = 0;
};

}  // namespace polhode
