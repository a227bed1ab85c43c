// SPDX-License-Identifier: Apache-2.0
// One rewritten line on standard error while the command works: share done, time left, what is being worked on.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace polhode::cli {

/// Shows nothing unless standard error is a terminal. The line is gone when the object is.
class progress_line {
 public:
  explicit progress_line(bool wanted);
  ~progress_line();
  progress_line(const progress_line&) = delete;
  progress_line& operator=(const progress_line&) = delete;

  void show(double share, std::string_view what);

 private:
  using clock = std::chrono::steady_clock;
  bool shown_;
  clock::time_point start_ = clock::now(), next_ = start_;
};

/// A line that stays, for logs: "weak: 4 of 10 experiments after 12 s".
void progress_note(std::string_view);

/// "12 s", "3 min 20 s", "1 h 12 min".
std::string duration_text(double seconds);

/// Wipes the line if there is one. Safe in a signal handler.
void clear_progress() noexcept;

}  // namespace polhode::cli
