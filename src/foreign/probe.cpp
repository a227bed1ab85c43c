// SPDX-License-Identifier: Apache-2.0
#include "foreign/probe.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <polhode/increment.hpp>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "ensemble/kernel.hpp"

namespace polhode::foreign {
namespace {

// An array between two pages that end whoever touches them.

/// Ends where the page behind it begins; what is left before it is checked by `touched`.
template <class T>
class guarded_array {
 public:
  explicit guarded_array(std::size_t count) : count_(count), page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    inside_ = (count * sizeof(T) + page_ - 1) / page_ * page_;
    void* all = mmap(nullptr, inside_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    base_ = static_cast<std::byte*>(all);
    if (inside_ > 0 && mprotect(base_ + page_, inside_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  }
  guarded_array(const guarded_array&) = delete;
  guarded_array& operator=(const guarded_array&) = delete;
  ~guarded_array() { munmap(base_, inside_ + 2 * page_); }

  std::span<T> values() { return {reinterpret_cast<T*>(base_ + page_ + inside_ - count_ * sizeof(T)), count_}; }
  T* data() { return values().data(); }

  /// Whether anything but zero stands before the array.
  bool touched() const {
    for (std::size_t i = 0; i < inside_ - count_ * sizeof(T); ++i)
      if (base_[page_ + i] != std::byte{}) return true;
    return false;
  }
  void write_protect() {
    if (inside_ > 0) mprotect(base_ + page_, inside_, PROT_READ);
  }

 private:
  std::size_t count_, page_, inside_ = 0;
  std::byte* base_ = nullptr;
};

constexpr int steps = 16;
constexpr unsigned most_seconds = 60;
constexpr int done = 77;  // exit code of a child that came to its end: no other way leads there

/// One block under noise that is the same each time.
class tried_block {
 public:
  tried_block(const description& d, const problem& p)
      : states_(size(p.components)),
        dw_(size(steps * p.channels)),
        area_(size(steps * pairs_among(p.channels))),
        seed_(size(steps)),
        takes_(d.takes),
        p_(p) {
    for (std::size_t i = 0; i < dw_.values().size(); ++i)
      dw_.values()[i] = std::sqrt(p.dt) * std::sin(1.0 + 2.0 * static_cast<double>(i));
    for (std::size_t i = 0; i < area_.values().size(); ++i)
      area_.values()[i] = p.dt / 2 * std::cos(1.0 + 3.0 * static_cast<double>(i));
    for (std::size_t i = 0; i < seed_.values().size(); ++i) seed_.values()[i] = 0x9E3779B97F4A7C15u * (i + 1);
    dw_.write_protect();
    area_.write_protect();
    seed_.write_protect();
    start();
  }

  void start() {
    for (std::size_t k = 0; k < p_.scene.momentum.size(); ++k)
      std::fill_n(states_.data() + k * block_lanes, block_lanes, p_.scene.momentum[k]);
  }
  batch all() {
    const bool own = takes_ == noise_access::own_numbers;
    return {block_lanes,
            steps,
            states_.data(),
            own || p_.channels == 0 ? nullptr : dw_.data(),
            takes_ == noise_access::areas ? area_.data() : nullptr,
            own ? seed_.data() : nullptr};
  }
  std::vector<double> states() { return {states_.values().begin(), states_.values().end()}; }
  bool wrote_before() const { return states_.touched(); }

 private:
  static std::size_t size(int rows) { return static_cast<std::size_t>(rows) * block_lanes; }
  guarded_array<double> states_, dw_, area_;
  guarded_array<std::uint64_t> seed_;
  noise_access takes_;
  const problem& p_;
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::vector<double> run_once(integrator& i, const problem& p) {
  tried_block b(i.about(), p);
  const auto opened = i.open(p);
  opened->advance(b.all());
  if (b.wrote_before()) throw failure("writes before the states that it is handed");
  return b.states();
}

/// Whether a thread gets what it gets alone while another steps from another state: until each has seen the other come
/// on often enough, however busy the machine is. What cannot be tried is not so.
bool two_at_a_time(integrator& i, const problem& p) {
  using namespace std::chrono_literals;
  constexpr int often = 32, few = 2;
  constexpr auto patience = 2s, end = 20s;  // then few will do; then it has not been seen
  auto other = p;
  for (double& x : other.scene.momentum) x = -x;
  const std::array problems{p, other};
  const std::array alone{run_once(i, problems[0]), run_once(i, problems[1])};
  std::array<std::atomic<int>, 2> calls{}, met{};
  std::atomic<bool> same = true, over = false;
  const auto begun = std::chrono::steady_clock::now();
  const auto run = [&](std::size_t k) {
    try {
      for (int seen = 0; same && !over;) {
        if (!same_bits(run_once(i, problems[k]), alone[k])) same = false;
        ++calls[k];
        if (const int theirs = calls[1 - k]; std::exchange(seen, theirs) != theirs) ++met[k];
        const int least = std::min(met[0].load(), met[1].load());
        const auto taken = std::chrono::steady_clock::now() - begun;
        if (least >= often || (least >= few && taken > patience)) over = true;
        if (taken > end) same = false;
      }
    } catch (const failure&) {
      same = false;
    }
  };
  std::thread second(run, 1);
  run(0);
  second.join();
  return same;
}

/// In the child. The answer is what goes through the pipe: a reason, or which of the two holds.
std::string answer(integrator& i, const problem& p) try {
  probed found;
  const auto once = run_once(i, p);
  found.repeats = same_bits(once, run_once(i, p));
  if (found.repeats && !i.about().one_thread) found.two_at_a_time = two_at_a_time(i, p);
  return fmt::format("+{}{}", found.repeats ? 1 : 0, found.two_at_a_time ? 1 : 0);
} catch (const refusal& r) {
  return fmt::format("!{}", r.what());
} catch (const std::exception& e) {
  return fmt::format("-{}", e.what());
}

[[noreturn]] void be_child(integrator& i, const problem& p, int to) {
  for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM}) std::signal(s, SIG_DFL);
  alarm(most_seconds);
  const auto text = answer(i, p);
  const auto written = write(to, text.data(), text.size());
  _exit(written == static_cast<ssize_t>(text.size()) ? done : 1);
}

std::string all_from(int fd) {
  std::string out;
  std::array<char, 1024> piece;
  for (ssize_t n; (n = read(fd, piece.data(), piece.size())) != 0;) {
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) break;
    out.append(piece.data(), static_cast<std::size_t>(n));
  }
  return out;
}

std::string ending(int status) {
  if (WIFSIGNALED(status)) {
    const int s = WTERMSIG(status);
    if (s == SIGALRM) return fmt::format("did not come back within {} s", most_seconds);
    const bool memory = s == SIGSEGV || s == SIGBUS;
    return fmt::format("was killed by signal {} ({}){}", s, strsignal(s),
                       memory ? ": it reads or writes beyond the arrays that it is handed, or elsewhere" : "");
  }
  return fmt::format("ended the program with exit code {}", WEXITSTATUS(status));
}

}  // namespace

probed probe(integrator& i, const problem& p) {
  if (!i.within()) {
    const auto once = run_once(i, p);
    return {same_bits(once, run_once(i, p)), true};
  }
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw failure("cannot be tried: no pipe");
  const auto child = fork();
  if (child == 0) {
    close(ends[0]);
    be_child(i, p, ends[1]);
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    throw failure("cannot be tried: no process");
  }
  const auto text = all_from(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != done) throw failure(ending(status));
  if (text.starts_with('!')) throw refusal(text.substr(1));
  if (text.starts_with('-')) throw failure(text.substr(1));
  if (text.size() != 3) throw failure(ending(status));
  return {text[1] == '1', text[2] == '1'};
}

double cost_of_step(integrator& i, const problem& p) {
  tried_block b(i.about(), p);
  const auto opened = i.open(p);
  double fastest = std::numeric_limits<double>::infinity();
  for (int call = 0; call < 5; ++call) {
    b.start();
    const auto begun = std::chrono::steady_clock::now();
    opened->advance(b.all());
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begun;
    fastest = std::min(fastest, taken.count() / (steps * block_lanes));
  }
  return fastest;
}

}  // namespace polhode::foreign
