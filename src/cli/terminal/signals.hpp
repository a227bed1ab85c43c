// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM end the command at once, but never in the middle of writing a report.
#pragma once

#include <string>

namespace polhode::cli {

/// Ends the program where it stands, with what it has started; may be called by a signal's handler.
[[noreturn]] void end_at_once(int code) noexcept;

/// Ends with 128 + signal; a reader that has gone (SIGPIPE) and a file at its limit (SIGXFSZ) become failed writes.
void install_signal_handlers();

/// What the end by a signal says on standard error, after "polhode: "; empty: nothing. By one thread; a signal may come
/// meanwhile.
void say_when_stopped(const std::string&);

/// While one lives, a signal waits; it ends the command when the last one goes.
class defer_signals {
 public:
  defer_signals();
  ~defer_signals();
  defer_signals(const defer_signals&) = delete;
  defer_signals& operator=(const defer_signals&) = delete;
};

}  // namespace polhode::cli
