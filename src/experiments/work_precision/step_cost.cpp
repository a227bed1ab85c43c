// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/step_cost.hpp"

#include <algorithm>
#include <array>
#include <boost/align/aligned_allocator.hpp>
#include <cmath>
#include <ctime>
#include <memory>
#include <span>

#include "ensemble/lanes.hpp"
#include "ensemble/noise/paths.hpp"
#include "ensemble/yardstick.hpp"
#include "platform/denormals.hpp"

namespace polhode {
namespace {

// Of a run; a fixed amount of work, so that what is counted does not depend on it.
constexpr int chunk = 16, most_chunks = 16;
constexpr int slots = 9, end = 1;  // the second of nine and the last but one hold their median in 96 of 100 cases
constexpr int runs = 2;            // of a slot: the quicker one counts

/// CPU time of this thread in ns: what others do on the machine is not in it.
double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

/// Of a run. What a step of n components costs grows faster than n^2; in a field it costs several times as much.
int chunks_for(const subject& s) {
  constexpr int of_one_component = 432;
  const int n = s.model->dimension();
  if (s.sphere() && s.sphere()->has_field()) return most_chunks / 4;
  return std::clamp(of_one_component / (n * n * n), 1, most_chunks);
}

/// States at a place of their own in a page for each slot, all over it: loads and stores a page apart look alike to the
/// processor, and where the stack lies in its page differs from one run of the program to the next.
class placed_states {
 public:
  placed_states(std::size_t count, int slot)
      : memory_(page / sizeof(double) + count),
        values_(
            memory_.data() + static_cast<std::size_t>(slot) * (page / slots / cache_line * cache_line) / sizeof(double),
            count) {}
  std::span<double> values() const { return values_; }

 private:
  static constexpr std::size_t page = 4096;
  std::vector<double, boost::alignment::aligned_allocator<double, page>> memory_;
  std::span<double> values_;
};

/// One block of paths, set back to its start whenever the horizon is over.
class timed_block {
 public:
  timed_block(const context& c, const scheme_entry& scheme, double dt, int slot)
      : seed_(c.seed),
        silent_(c.subject.model->layout().silent()),
        stepper_(scheme.make(dt)),
        noise_(*c.subject.model, chunk, scheme.needs_areas, {c.generator, noise_quality::fast}),
        chunks_(chunks_for(c.subject)),
        start_(replicated(c.subject.scene.momentum)),
        states_(start_.size(), slot),
        chunks_to_horizon_(
            static_cast<int>(std::clamp(std::ceil(c.subject.scene.horizon / (dt * chunk)), 1.0, double(chunks_)))) {}

  /// A quarter of a run, or a chunk: fills the caches.
  void warm_up() { advance(std::max(1, chunks_ / 4)); }
  /// ns a path and step.
  double run() {
    const double begin = thread_time();
    advance(chunks_);
    return (thread_time() - begin) / (double{chunk} * chunks_ * block_lanes);
  }

 private:
  void advance(int chunks) {
    for (int i = 0; i < chunks; ++i) {
      const bool first = i % chunks_to_horizon_ == 0, last = (i + 1) % chunks_to_horizon_ == 0 || i + 1 == chunks;
      if (first) std::ranges::copy(start_, states_.values().begin());
      const auto at = static_cast<std::uint64_t>(i) * chunk;
      stepper_->advance(states_.values(), silent_ ? silence(chunk) : noise_.fill(seed_, 0, at, chunk, stepper_->dt()),
                        {first, last});
    }
  }

  std::uint64_t seed_;
  bool silent_;
  std::unique_ptr<kernel> stepper_;
  increment_buffer noise_;
  int chunks_;
  std::vector<double> start_;
  placed_states states_;
  int chunks_to_horizon_;
};

/// The loop that never changes, on memory of its own, which lies alike in every run of the program.
class yardstick {
 public:
  yardstick() : memory_(std::make_unique<memory>()) {
    for (std::size_t i = 0; i < memory_->table.size(); ++i)
      memory_->table[i] = 0.01 + 1e-5 * static_cast<double>(i % 97);
    memory_->states.fill(0.57735);
    for (std::size_t i = 0; i < memory_->mixed.size(); ++i) memory_->mixed[i] = static_cast<std::uint32_t>(i);
    run();
  }

  /// ns a path and step.
  double run() {
    double best = HUGE_VAL;
    for (int i = 0; i < runs; ++i) {
      const double begin = thread_time();
      run_yardstick({chunk * most_chunks, memory_->table.data(), memory_->states.data(), memory_->mixed.data()});
      best = std::min(best, (thread_time() - begin) / (double{chunk} * most_chunks * block_lanes));
    }
    return best;
  }

 private:
  struct alignas(4096) memory {
    std::array<double, 3 * block_lanes * yardstick_rows> table;
    std::array<double, 3 * block_lanes> states;
    std::array<std::uint32_t, 2 * block_lanes> mixed;
  };
  std::unique_ptr<memory> memory_;
};

/// ns a path and step of one slot.
double time_of_slot(const priced_step& step, int slot) {
  timed_block block(*step.where, *step.scheme, step.dt, slot);
  block.warm_up();
  double best = HUGE_VAL;
  for (int i = 0; i < runs; ++i) best = std::min(best, block.run());
  return best;
}

/// Sorts; of nine values the median and its interval.
std::array<double, 3> median_of(std::array<double, slots>& ratios) {
  std::ranges::sort(ratios);
  return {ratios[slots / 2], ratios[end], ratios[slots - 1 - end]};
}

}  // namespace

std::vector<step_cost> costs_of_steps(const std::vector<priced_step>& steps, yardstick_time* time) {
  if (steps.empty()) return {};
  const flush_denormals flushed;
  std::vector<std::array<double, slots>> ratios(steps.size());
  std::vector<double> yards;
  yardstick yard;
  for (int slot = 0; slot < slots; ++slot) {
    double before = yard.run();
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const double own = time_of_slot(steps[i], slot), after = yard.run();
      ratios[i][static_cast<std::size_t>(slot)] = own / std::sqrt(before * after);
      yards.push_back(before = after);
    }
  }
  std::ranges::sort(yards);
  const double unit = yards[yards.size() / 2];
  if (time) *time = {unit, yards[yards.size() / 4], yards[3 * yards.size() / 4]};
  std::vector<step_cost> out;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto [median, low, high] = median_of(ratios[i]);
    const double normals = steps[i].where->subject.model->layout().drawn(steps[i].scheme->needs_areas);
    out.push_back({unit * median, unit * low, unit * high, normals});
  }
  return out;
}

step_cost cost_of_step(const context& c, const scheme_entry& scheme, double dt) {
  return costs_of_steps({{&c, &scheme, dt}}).front();
}

double ns_per_normal(const context& c) {
  const int active = c.subject.model->layout().active;
  if (active == 0) return 0;
  const flush_denormals flushed;
  increment_buffer noise(*c.subject.model, chunk, false, {c.generator, noise_quality::fast});
  std::array<double, 9> ns{};
  for (double& one : ns) {
    const double begin = thread_time();
    for (int i = 0; i < most_chunks; ++i) noise.fill(c.seed, 0, static_cast<std::uint64_t>(i) * chunk, chunk, 1);
    one = (thread_time() - begin) / (double{chunk} * most_chunks * block_lanes * active);
  }
  return std::ranges::min(ns);
}

}  // namespace polhode
