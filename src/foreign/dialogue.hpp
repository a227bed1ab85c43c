// SPDX-License-Identifier: Apache-2.0
// What is said to a child and what it answers, within a time: neither side waits for the other for ever.
#pragma once

#include <sys/uio.h>

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "foreign/child.hpp"

namespace polhode::foreign {

class dialogue {
 public:
  /// Starts the program; every exchange may take `deadline` seconds. Throws failure.
  dialogue(const std::vector<std::string>& words, double deadline);

  /// Begins an exchange. The bytes stay where they are until its answer has come.
  void say(std::span<const iovec> bytes);

  /// Writes what is still to be said, and reads into `answer` behind its first `got` bytes until there are `wanted`, or
  /// more. Returns how many there are. Throws failure: it has ended, does not answer, does not read.
  std::size_t hear(std::span<std::byte> answer, std::size_t got, std::size_t wanted);

  /// Whether all has been read that was said: an answer before that is none.
  bool said_all() const { return unsaid_.empty(); }

  /// What else it writes shortly, for words about it.
  std::string overheard();

  /// Throws failure, with the last words on the standard error stream of the child.
  [[noreturn]] void fail(const std::string& what);

 private:
  using clock = std::chrono::steady_clock;

  void write();
  void stop_talking();
  void wait(std::size_t got);
  bool keep_errors();
  [[noreturn]] void fail_at_end(std::size_t got);
  [[noreturn]] void fail_at_deadline(std::size_t got);

  child child_;
  std::chrono::duration<double> deadline_;
  clock::time_point until_;
  std::vector<iovec> unsaid_;
  bool reads_ = true, complains_ = true;  ///< its ends of the pipes are open
  std::string errors_;                    ///< the end of its standard error stream
};

}  // namespace polhode::foreign
