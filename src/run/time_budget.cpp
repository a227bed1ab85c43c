// SPDX-License-Identifier: Apache-2.0
#include "run/time_budget.hpp"

#include <chrono>

#include "platform/stopping.hpp"

namespace polhode {

time_budget::time_budget(double seconds)
    : seconds_(seconds),
      clock_([this, end = std::chrono::steady_clock::now() +
                          std::chrono::duration<double>(seconds)](const std::stop_token& over) {
        std::unique_lock lock(waiting_);
        ended_.wait_until(lock, over, end, [] { return false; });
        if (!over.stop_requested()) used_up_ = true;
      }) {}

bool within(const time_budget* budget, const std::function<void()>& work) {
  if (budget != nullptr && budget->used_up()) return false;
  const stoppable until(budget != nullptr ? &budget->used_up_ : nullptr);
  try {
    work();
  } catch (const stopped&) {
    if (budget == nullptr || !budget->used_up()) throw;  // somebody else has asked for it
    return false;
  }
  return true;
}

}  // namespace polhode
