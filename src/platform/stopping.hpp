// SPDX-License-Identifier: Apache-2.0
// Work that somebody may stop: whoever runs it owns a flag, and it ends with an exception soon after that is raised.
#pragma once

#include <atomic>

namespace polhode {

/// Thrown out of work whose flag is up. No error of anybody's, hence no std::exception.
struct stopped {};

/// While it lives, this thread's work can be stopped by that flag, or none, besides whoever could stop it before.
class stoppable {
 public:
  explicit stoppable(const std::atomic<bool>* flag);
  /// In a thread that works for another: by whoever can stop that one's, which waits meanwhile.
  explicit stoppable(const stoppable* other);
  ~stoppable();
  stoppable(const stoppable&) = delete;
  stoppable& operator=(const stoppable&) = delete;

  bool asked() const;

 private:
  const std::atomic<bool>* flag_;
  const stoppable *outer_, *before_;
};

/// Who can stop this thread's work; null: nobody.
const stoppable* stoppable_here();

/// Throws `stopped` where that is asked for. Called between pieces of work.
void stop_if_asked();

}  // namespace polhode
