// Counts finished pieces of work from many threads and passes the share on, one call at a time.
#pragma once

#include <functional>
#include <mutex>

namespace polhode {

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
