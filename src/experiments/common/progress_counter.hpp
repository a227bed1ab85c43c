// SPDX-License-Identifier: Apache-2.0
// How far an experiment is: shares of its parts, and pieces that many threads finish.
#pragma once

#include <functional>
#include <mutex>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// The same run, whose progress goes from `from` to `to` of it. Valid as long as that.
inline context part_of(const context& c, double from, double to) {
  auto part = c;
  part.progress = [=, &c](double share) { c.progress(from + (to - from) * share); };
  return part;
}

/// Passes the share on, one call at a time.
class progress_counter {
 public:
  progress_counter(int total, const std::function<void(double)>& sink) : total_(total), sink_(sink) {}
  void add() {
    const std::lock_guard lock(mutex_);
    sink_(static_cast<double>(++done_) / total_);
  }

 private:
  int total_, done_ = 0;
  const std::function<void(double)>& sink_;
  std::mutex mutex_;
};

}  // namespace polhode
