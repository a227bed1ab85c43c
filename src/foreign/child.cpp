// SPDX-License-Identifier: Apache-2.0
#include "foreign/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <system_error>
#include <utility>

#include "foreign/integrator.hpp"

namespace polhode::foreign {
namespace {

constexpr int pipe_bytes = 1 << 18;  // several blocks of paths and their noise

/// Groups of processes, for kill_children; 0: free.
std::array<std::atomic<pid_t>, 2048> alive;
static_assert(std::atomic<pid_t>::is_always_lock_free, "used in a signal handler");

void exchange_in_alive(pid_t from, pid_t to) {
  for (auto& slot : alive)
    if (pid_t expected = from; slot.compare_exchange_strong(expected, to)) return;
}

std::string reason(int code) { return std::generic_category().message(code); }

/// Both ends are closed in programs that are started.
struct pipe_ends {
  int read = -1, write = -1;
  pipe_ends() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw failure("no pipe: " + reason(errno));
    read = ends[0];
    write = ends[1];
  }
  pipe_ends(const pipe_ends&) = delete;
  pipe_ends& operator=(const pipe_ends&) = delete;
  ~pipe_ends() {
    for (const int end : {read, write})
      if (end >= 0) ::close(end);
  }
  static int taken(int& end) {
    ::fcntl(end, F_SETFL, O_NONBLOCK);
    return std::exchange(end, -1);
  }
};

/// In a group of its own, with the signals of a program that a shell starts.
struct spawn_settings {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  spawn_settings(int in, int out, int err) {
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, in, 0);
    ::posix_spawn_file_actions_adddup2(&files, out, 1);
    ::posix_spawn_file_actions_adddup2(&files, err, 2);
    sigset_t none, usual;
    ::sigemptyset(&none);
    ::sigemptyset(&usual);
    for (const int s : {SIGPIPE, SIGINT, SIGTERM}) ::sigaddset(&usual, s);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &usual);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  spawn_settings(const spawn_settings&) = delete;
  spawn_settings& operator=(const spawn_settings&) = delete;
  ~spawn_settings() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
  }
};

/// A child that has gone makes a write fail instead of ending this program.
void ignore_broken_pipes() {
  struct sigaction now {};
  if (::sigaction(SIGPIPE, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace

std::vector<std::string> words_of(const std::string& command) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  wordexp_t found{};
  const int code = ::wordexp(command.c_str(), &found, WRDE_NOCMD);
  if (code == WRDE_BADCHAR) throw failure("has one of | & ; < > ( ) { } or a new line outside quotes");
  if (code == WRDE_CMDSUB) throw failure("has a command to be substituted, $(...) or `...`");
  if (code != 0) throw failure("is no command line: a quote or a bracket is not closed");
  std::vector<std::string> words(found.we_wordv, found.we_wordv + found.we_wordc);
  ::wordfree(&found);
  if (words.empty()) throw failure("is empty");
  return words;
}

child::child(const std::vector<std::string>& words) {
  ignore_broken_pipes();
  pipe_ends in, out, err;
  ::fcntl(in.write, F_SETPIPE_SZ, pipe_bytes);  // else it stays as small as it is
  const spawn_settings how(in.read, out.write, err.write);
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  if (const int code = ::posix_spawnp(&process_, arguments[0], &how.files, &how.attributes, arguments.data(), environ))
    throw failure(fmt::format("{}: cannot be started: {}", words[0], reason(code)));
  exchange_in_alive(0, process_);
  in_ = pipe_ends::taken(in.write);
  out_ = pipe_ends::taken(out.read);
  err_ = pipe_ends::taken(err.read);
}

child::~child() {
  for (const int end : {in_, out_, err_}) ::close(end);
  ::kill(-process_, SIGKILL);
  exchange_in_alive(process_, 0);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<std::string> child::end() {
  // Left unreaped, so that its group keeps its number until it is ended.
  siginfo_t how{};
  if (::waitid(P_PID, static_cast<id_t>(process_), &how, WEXITED | WNOHANG | WNOWAIT) != 0 || how.si_pid == 0)
    return {};
  if (how.si_code == CLD_EXITED) return fmt::format("ended with exit code {}", how.si_status);
  return fmt::format("killed by signal {} ({})", how.si_status, ::strsignal(how.si_status));
}

void kill_children() {
  for (auto& slot : alive)
    if (const pid_t group = slot.load(); group != 0) ::kill(-group, SIGKILL);
}

}  // namespace polhode::foreign
