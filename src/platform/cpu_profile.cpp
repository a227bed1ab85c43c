// SPDX-License-Identifier: Apache-2.0
#include "platform/cpu_profile.hpp"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace polhode {
namespace {

constexpr std::chrono::milliseconds between_looks{2};

double seconds_of(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// A thread that has said what it works on, from then to its end.
struct worker {
  worker();
  ~worker();
  worker(const worker&) = delete;
  worker& operator=(const worker&) = delete;

  /// Seconds since the last time.
  double used() {
    const double before = std::exchange(seen, seconds_of(clock));
    return seen - before;
  }

  std::atomic<const char*> what{""};
  clockid_t clock{};
  double seen = 0;
};

struct all_workers {
  std::mutex one;
  std::vector<worker*> now;
  std::map<std::string, double> seconds;
  bool counting = false;

  void charge(worker& w) {
    const double used = w.used();
    if (counting) seconds[w.what.load(std::memory_order_relaxed)] += used;
  }
};
all_workers& everyone() {
  static all_workers all;
  return all;
}

worker::worker() {
  pthread_getcpuclockid(pthread_self(), &clock);
  auto& all = everyone();
  const std::lock_guard lock(all.one);
  seen = seconds_of(clock);
  all.now.push_back(this);
}

worker::~worker() {
  auto& all = everyone();
  const std::lock_guard lock(all.one);
  all.charge(*this);
  std::erase(all.now, this);
}

void look_at_all() {
  auto& all = everyone();
  const std::lock_guard lock(all.one);
  for (auto* w : all.now) all.charge(*w);
}

}  // namespace

void working_on(const char* what) noexcept {
  static thread_local worker mine;
  mine.what.store(what, std::memory_order_relaxed);
}

class cpu_profile::sampler {
 public:
  sampler() {
    look_at_all();
    const std::lock_guard lock(everyone().one);
    everyone().seconds.clear();
    everyone().counting = true;
  }
  ~sampler() {
    const std::lock_guard lock(everyone().one);
    everyone().counting = false;
  }

 private:
  std::jthread thread_{[](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      std::this_thread::sleep_for(between_looks);
      look_at_all();
    }
  }};
};

cpu_profile::cpu_profile() : sampler_(std::make_unique<sampler>()) {}
cpu_profile::~cpu_profile() = default;

std::map<std::string, double> cpu_profile::take() {
  look_at_all();
  const std::lock_guard lock(everyone().one);
  return std::exchange(everyone().seconds, {});
}

}  // namespace polhode
