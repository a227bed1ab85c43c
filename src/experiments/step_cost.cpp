#include "experiments/step_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "ensemble/denormals.hpp"
#include "ensemble/paths.hpp"

namespace polhode {
namespace {

constexpr int chunk = 16,
              chunks = 64;  // of a run; a fixed amount of work, so that what is counted does not depend on it
constexpr int runs = 9, left_out = 2;  // of the sorted runs, at either end: those that were disturbed

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
        start_(replicated(c.subject.scene.momentum)),
        chunks_to_horizon_(
            static_cast<int>(std::clamp(std::ceil(c.subject.scene.horizon / (dt * chunk)), 1.0, double{chunks}))) {}

  /// ns a path and step.
  double run() {
    const double begin = thread_time();
    for (int i = 0; i < chunks; ++i) {
      const bool first = i % chunks_to_horizon_ == 0, last = (i + 1) % chunks_to_horizon_ == 0 || i + 1 == chunks;
      if (first) states_ = start_;
      const auto at = static_cast<std::uint64_t>(i) * chunk;
      stepper_->advance(states_, silent_ ? silence(chunk, dt_) : noise_.fill(seed_, 0, at, chunk, dt_), {first, last});
    }
    return (thread_time() - begin) / (double{chunk} * chunks * block_lanes);
  }

 private:
  double dt_;
  std::uint64_t seed_;
  bool silent_;
  std::unique_ptr<kernel> stepper_;
  increment_buffer noise_;
  std::vector<double> start_, states_;
  int chunks_to_horizon_;
};

double normals_of(const model& m, bool areas) {
  const int active = m.active_channels(), pairs = m.channels() * (m.channels() - 1) / 2;
  return active + (areas && active > 1 ? pairs : 0);
}

}  // namespace

step_cost cost_of_step(const context& c, const scheme_entry& scheme, double dt) {
  const flush_denormals flushed;
  timed_block block(c, scheme, dt);
  block.run();  // warms the caches
  std::array<double, runs> ns{};
  for (double& one : ns) one = block.run();
  std::ranges::sort(ns);
  return {ns[runs / 2], ns[left_out], ns[runs - 1 - left_out], normals_of(*c.subject.model, scheme.needs_areas)};
}

double ns_per_normal(const context& c) {
  const int active = c.subject.model->active_channels();
  if (active == 0) return 0;
  const flush_denormals flushed;
  increment_buffer noise(*c.subject.model, chunk, false, {c.generator, noise_quality::fast});
  std::array<double, runs> ns{};
  for (double& one : ns) {
    const double begin = thread_time();
    for (int i = 0; i < chunks; ++i) noise.fill(c.seed, 0, static_cast<std::uint64_t>(i) * chunk, chunk, 1);
    one = (thread_time() - begin) / (double{chunk} * chunks * block_lanes * active);
  }
  std::ranges::sort(ns);
  return ns[runs / 2];
}

}  // namespace polhode
