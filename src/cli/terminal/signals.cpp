// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/signals.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "cli/terminal/progress.hpp"
#include "foreign/child.hpp"

namespace polhode::cli {
namespace {

std::atomic<int> deferring = 0, waiting = 0;
static_assert(std::atomic<int>::is_always_lock_free, "used in a signal handler");

void end_by(int signal) { end_at_once(128 + signal); }

extern "C" void handle_signal(int signal) {
  if (deferring == 0) end_by(signal);
  waiting = signal;
}

}  // namespace

void end_at_once(int code) noexcept {
  clear_progress();
  foreign::kill_children();
  ::_exit(code);
}

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = handle_signal;
  ::sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction former {};
    // What the parent chose to ignore (nohup, a background job) stays ignored.
    if (::sigaction(signal, nullptr, &former) == 0 && former.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &action, nullptr);
  }
  for (const int of_a_write : {SIGPIPE, SIGXFSZ}) std::signal(of_a_write, SIG_IGN);
}

defer_signals::defer_signals() { ++deferring; }

defer_signals::~defer_signals() {
  if (--deferring == 0 && waiting != 0) end_by(waiting);
}

}  // namespace polhode::cli
