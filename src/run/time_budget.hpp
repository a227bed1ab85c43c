// SPDX-License-Identifier: Apache-2.0
// The time that a run may take: what is at work when it is up is stopped.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace polhode {

/// Thrown where the time of a run is up, for any of the processes that share it, and work is not done.
struct out_of_time {};

/// Of so many seconds from now on.
class time_budget {
 public:
  explicit time_budget(double seconds);

  double seconds() const { return seconds_; }
  bool used_up() const { return used_up_; }

 private:
  friend bool within(const time_budget*, const std::function<void()>&);

  double seconds_;
  std::atomic<bool> used_up_ = false;
  std::mutex waiting_;
  std::condition_variable_any ended_;
  std::jthread clock_;  ///< ends, and is waited for, before what it uses
};

/// Works, unless the budget is used up or until it is; null: without a limit. False: the work is not done, and what it
/// has done is of no use.
bool within(const time_budget*, const std::function<void()>& work);

}  // namespace polhode
