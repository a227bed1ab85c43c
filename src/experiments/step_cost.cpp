#include "experiments/step_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "ensemble/denormals.hpp"
#include "ensemble/paths.hpp"
#include "ensemble/yardstick.hpp"

namespace polhode {
namespace {

// Of a run; a fixed amount of work, so that what is counted does not depend on it. Steps without noise are short.
constexpr int chunk = 16, noisy_chunks = 32, silent_chunks = 128;
constexpr int slots = 9, end = 1;  // the second of nine and the last but one hold their median in 96 of 100 cases
constexpr int runs = 2;            // of a slot: the quicker one counts

/// CPU time of this thread in ns: what others do on the machine is not in it.
double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

/// One block of paths, set back to its start whenever the horizon is over.
class timed_block {
 public:
  timed_block(const context& c, const scheme_entry& scheme, double dt)
      : dt_(dt),
        seed_(c.seed),
        silent_(c.subject.model->active_channels() == 0),
        stepper_(scheme.make(dt)),
        noise_(*c.subject.model, chunk, scheme.needs_areas, {c.generator, noise_quality::fast}),
        chunks_(silent_ && !scheme.info.implicit ? silent_chunks : noisy_chunks),
        start_(replicated(c.subject.scene.momentum)),
        chunks_to_horizon_(
            static_cast<int>(std::clamp(std::ceil(c.subject.scene.horizon / (dt * chunk)), 1.0, double(chunks_)))) {}

  /// ns a path and step.
  double run() {
    const double begin = thread_time();
    for (int i = 0; i < chunks_; ++i) {
      const bool first = i % chunks_to_horizon_ == 0, last = (i + 1) % chunks_to_horizon_ == 0 || i + 1 == chunks_;
      if (first) states_ = start_;
      const auto at = static_cast<std::uint64_t>(i) * chunk;
      stepper_->advance(states_, silent_ ? silence(chunk, dt_) : noise_.fill(seed_, 0, at, chunk, dt_), {first, last});
    }
    return (thread_time() - begin) / (double{chunk} * chunks_ * block_lanes);
  }

 private:
  double dt_;
  std::uint64_t seed_;
  bool silent_;
  std::unique_ptr<kernel> stepper_;
  increment_buffer noise_;
  int chunks_;
  std::vector<double> start_, states_;
  int chunks_to_horizon_;
};

double normals_of(const model& m, bool areas) {
  const int active = m.active_channels(), pairs = m.channels() * (m.channels() - 1) / 2;
  return active + (areas && active > 1 ? pairs : 0);
}

/// The loop that never changes, on memory of its own.
class yardstick {
 public:
  yardstick() : table_(3 * block_lanes * yardstick_rows), states_(3 * block_lanes, 0.57735), mixed_(2 * block_lanes) {
    for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = 0.01 + 1e-5 * static_cast<double>(i % 97);
    for (std::size_t i = 0; i < mixed_.size(); ++i) mixed_[i] = static_cast<std::uint32_t>(i);
    run();
  }

  /// ns a path and step.
  double run() {
    double best = HUGE_VAL;
    for (int i = 0; i < runs; ++i) {
      const double begin = thread_time();
      run_yardstick({chunk * noisy_chunks, table_.data(), states_.data(), mixed_.data()});
      best = std::min(best, (thread_time() - begin) / (double{chunk} * noisy_chunks * block_lanes));
    }
    return best;
  }

 private:
  std::vector<double> table_, states_;
  std::vector<std::uint32_t> mixed_;
};

/// ns a path and step of one slot, its memory at another place than that of the slots before.
double time_of_slot(const priced_step& step, int slot) {
  const std::vector<double> elsewhere(static_cast<std::size_t>(1 + 520 * slot));
  [[maybe_unused]] const volatile double kept = elsewhere.back();
  timed_block block(*step.where, *step.scheme, step.dt);
  block.run();  // warms the caches
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
    out.push_back({unit * median, unit * low, unit * high,
                   normals_of(*steps[i].where->subject.model, steps[i].scheme->needs_areas)});
  }
  return out;
}

step_cost cost_of_step(const context& c, const scheme_entry& scheme, double dt) {
  return costs_of_steps({{&c, &scheme, dt}}).front();
}

double ns_per_normal(const context& c) {
  const int active = c.subject.model->active_channels();
  if (active == 0) return 0;
  const flush_denormals flushed;
  increment_buffer noise(*c.subject.model, chunk, false, {c.generator, noise_quality::fast});
  std::array<double, 9> ns{};
  for (double& one : ns) {
    const double begin = thread_time();
    for (int i = 0; i < noisy_chunks; ++i) noise.fill(c.seed, 0, static_cast<std::uint64_t>(i) * chunk, chunk, 1);
    one = (thread_time() - begin) / (double{chunk} * noisy_chunks * block_lanes * active);
  }
  return std::ranges::min(ns);
}

}  // namespace polhode
