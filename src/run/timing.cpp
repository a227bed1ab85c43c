// SPDX-License-Identifier: Apache-2.0
#include "run/timing.hpp"

#include <algorithm>
#include <ctime>

namespace polhode {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void stopwatch::read(report::provenance& p) const {
  p.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  p.cpu_seconds = cpu_seconds() - cpu_start_;
}

experiment_profile::experiment_profile(bool wanted) {
  if (wanted) profile_.emplace();
}

void experiment_profile::begin() {
  if (!profile_) return;
  working_on("");
  profile_->take();
  cpu_start_ = cpu_seconds();
}

void experiment_profile::end(const std::string& experiment, std::vector<report::profile_row>& out) {
  if (!profile_) return;
  double rest = cpu_seconds() - cpu_start_;
  for (const auto& [what, seconds] : profile_->take()) {
    if (what.empty()) continue;
    out.push_back({experiment, what, seconds});
    rest -= seconds;
  }
  out.push_back({experiment, "", std::max(0.0, rest)});
}

}  // namespace polhode
