// SPDX-License-Identifier: Apache-2.0
// Work that somebody may stop: whoever runs it owns a flag, and it ends with an exception soon after that is raised.
#pragma once

#include <atomic>

namespace polhode {

/// Thrown out of work whose flag is up. No error of anybody's, hence no std::exception.
struct stopped {};

/// While it lives, this thread's work can be stopped by that flag, and that of threads which parallel_for starts for
/// it.
class stoppable {
 public:
  explicit stoppable(const std::atomic<bool>* flag);
  ~stoppable();
  stoppable(const stoppable&) = delete;
  stoppable& operator=(const stoppable&) = delete;

 private:
  const std::atomic<bool>* before_;
};

/// This thread's flag; null: nobody can stop it.
const std::atomic<bool>* stop_flag();

/// Throws `stopped` where the flag is up. Called between pieces of work.
void stop_if_asked();

}  // namespace polhode
