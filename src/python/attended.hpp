// SPDX-License-Identifier: Apache-2.0
// The laboratory at work while Python waits: without the interpreter's lock, and interruptible from the keyboard.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <string>
#include <utility>

#include "platform/stopping.hpp"
#include "run/progress_sink.hpp"

namespace polhode::python {

/// What passes between the work and who waits for it.
class attendance {
 public:
  /// progress(share, what): a Python callable, or None.
  explicit attendance(pybind11::object progress) : progress_(std::move(progress)) {}

  const std::atomic<bool>* flag() const { return &stop_; }
  /// The work ends, and who waits throws this.
  void stop(std::exception_ptr why);
  /// For the work: says how far it is, and throws `stopped` where it is to end.
  progress_sink sink();

  /// A callable at work, which a stop interrupts where it is. Lives with the lock held.
  class inside {
   public:
    explicit inside(attendance& of) : of_(of) { of_.caller_ = PyThread_get_thread_ident(); }
    ~inside() { of_.caller_ = 0; }
    inside(const inside&) = delete;
    inside& operator=(const inside&) = delete;

   private:
    attendance& of_;
  };

  /// For who waits, with the lock held: signals that have come, and the progress to be told.
  void look();
  void rethrow() const;

 private:
  pybind11::object progress_;
  std::atomic<bool> stop_ = false;
  mutable std::mutex guard_;
  std::exception_ptr why_;
  double share_ = -1, told_ = -1;
  std::string what_;
  unsigned long caller_ = 0;  ///< its thread, by Python's number; guarded by the interpreter's lock
};

/// What `work` returns. It runs in a thread of its own; this one, which holds the lock now and then only, looks after
/// signals, as Python hands those to its main thread alone.
template <class Work>
auto attended(attendance& with, Work work) {
  constexpr auto pause = std::chrono::milliseconds{50};
  auto result = std::async(std::launch::async, [&] {
    const stoppable here(with.flag());
    return work();
  });
  const auto is_there = [&] {
    const pybind11::gil_scoped_release meanwhile;
    return result.wait_for(pause) == std::future_status::ready;
  };
  while (!is_there()) with.look();
  with.rethrow();
  return result.get();
}

}  // namespace polhode::python
