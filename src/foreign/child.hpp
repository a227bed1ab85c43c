// SPDX-License-Identifier: Apache-2.0
// A program that runs beside the laboratory, with pipes at its standard streams.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace polhode::foreign {

/// The words of a command line as a shell splits it: quotes, variables, ~ and patterns, but no operators and no
/// substitution of commands. Throws failure.
std::vector<std::string> words_of(const std::string& command);

/// Ends its program, with all that this has started itself, when it is destroyed. Our ends of the pipes do not block,
/// and no other child inherits them.
class child {
 public:
  explicit child(const std::vector<std::string>& words);  ///< throws failure where it cannot be started
  ~child();
  child(const child&) = delete;
  child& operator=(const child&) = delete;

  int in() const { return in_; }
  int out() const { return out_; }
  int err() const { return err_; }

  /// How it has ended: "ended with exit code 3"; nothing while it runs.
  std::optional<std::string> end();

 private:
  pid_t process_ = 0;
  int in_ = -1, out_ = -1, err_ = -1;
};

/// Ends all children at once; may be called by a signal's handler.
void kill_children();

}  // namespace polhode::foreign
