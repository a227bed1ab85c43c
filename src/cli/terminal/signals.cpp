// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/signals.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <deque>

#include "cli/terminal/progress.hpp"
#include "cli/terminal/terminal.hpp"
#include "foreign/child.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/disk.hpp"

namespace polhode::cli {
namespace {

std::atomic<int> deferring = 0, waiting = 0;
static_assert(std::atomic<int>::is_always_lock_free, "used in a signal handler");

std::atomic<const std::string*> last_words = nullptr;

/// Not where nobody reads: a full pipe would hold up the end.
void print_last_words() {
  pollfd room{STDERR_FILENO, POLLOUT, 0};
  const auto* words = last_words.load();
  if (words != nullptr && ::poll(&room, 1, 0) == 1 && (room.revents & POLLOUT) != 0) print_aside(*words);
}

void end_by(int signal) {
  clear_progress();
  report::disk::remove_last_staged();
  print_last_words();
  end_at_once(128 + signal);
}

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

void say_when_stopped(const std::string& words) {
  static std::deque<std::string> said;  // none of them goes away: a handler may be reading it
  const auto line = words.empty() ? "" : fmt::format("polhode: {}\n", one_line(words, 500));
  if (said.empty() || said.back() != line) said.push_back(line);
  last_words = &said.back();
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
