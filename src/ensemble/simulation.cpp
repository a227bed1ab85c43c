// SPDX-License-Identifier: Apache-2.0
#include "ensemble/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "ensemble/noise_at.hpp"

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/observing/block_record.hpp"
#include "ensemble/observing/direction_bins.hpp"
#include "ensemble/observing/sphere_bins.hpp"
#include "ensemble/orbit_start.hpp"
#include "ensemble/uniform_start.hpp"

namespace polhode {
namespace {

constexpr int chunk = 16;                       // steps of a block's own increments: they stay in the nearest caches
constexpr std::int64_t longest_slice = 65'536;  // steps between two words on progress

std::int64_t blocks_of(const simulation_plan& p) { return (p.bodies + block_lanes - 1) / block_lanes; }

/// Blocks that one thread takes at a time: by the ensemble alone, as sums are merged piece by piece.
std::int64_t blocks_a_piece(const simulation_plan& p) { return std::clamp<std::int64_t>(blocks_of(p) / 1024, 1, 64); }

/// Increments, and the table of what a kernel does with them, at most a shared_step each.
double shared_bytes(const model& m, const simulation_plan& p) {
  return shared_increments::bytes(m, p.steps, p.with_areas) + static_cast<double>(p.steps) * sizeof(shared_step);
}

/// Everything that the pieces share.
class ensemble_run {
 public:
  ensemble_run(const model& m, const kernel& k, const simulation_plan& p, const std::function<void(double)>& progress)
      : model_(m), kernel_(k), plan_(p), progress_(progress), counting_(p.snapshots.size()) {
    noiseless_ = p.noise == ensemble_noise::none || m.layout().silent();
    if (p.start == ensemble_start::orbit) orbit_.emplace(m, p.momentum);
    if (!noiseless_ && p.noise == ensemble_noise::common) {
      const shared_increments drawn(m, p.seed, p.steps, k.dt(), p.with_areas, p.threads, p.source, p.path);
      const auto all = drawn.view(0, static_cast<int>(p.steps));
      if (p.hear) p.hear(all);
      common_ = k.share(all);
      out_.drawn = drawn.drawn();
    }
    out_.states.resize(static_cast<std::size_t>(m.dimension()) * static_cast<std::size_t>(p.bodies));
    out_.snapshots.resize(p.snapshots.size());
    for (auto& s : out_.snapshots) {
      s.counts.resize(longitude_bins::count);
      s.picture.resize(hemisphere_bins::count);
    }
    moments_.resize(static_cast<std::size_t>(pieces()),
                    std::vector<ensemble_moments>(p.snapshots.size() + 1, ensemble_observer::nothing(model_)));
  }

  int pieces() const {
    return static_cast<int>((blocks_of(plan_) + blocks_a_piece(plan_) - 1) / blocks_a_piece(plan_));
  }

  void run_piece(int piece) {
    increment_buffer noise(model_, chunk, plan_.with_areas, plan_.source);
    ensemble_observer observer(model_, plan_.momentum);
    auto states = replicated(plan_.momentum);
    std::vector<double> seen;
    block_record recorded(model_.dimension(), plan_.record);
    const bool records = plan_.record_every > 0;
    auto& moments = moments_[static_cast<std::size_t>(piece)];
    const std::int64_t first = piece * blocks_a_piece(plan_);
    for (auto block = first; block < std::min(first + blocks_a_piece(plan_), blocks_of(plan_)); ++block) {
      start(block, states);
      if (records) {
        recorded.start(block * block_lanes, lanes_of(block));
        recorded.add(states);
      }
      std::size_t snapshot = 0;
      for (std::int64_t step = 0; step < plan_.steps;) {
        const auto stop = next_stop(step, snapshot);
        while (step < stop) {
          const auto n = std::min(stop - step, longest_slice);
          advance(states, block, step, n, noise);
          step += n;
          tell(n);
        }
        seen = states;
        if (step < plan_.steps) kernel_.finish(seen);
        if (records && step % plan_.record_every == 0) recorded.add(seen);
        if (snapshot < plan_.snapshots.size() && step == plan_.snapshots[snapshot]) {
          observer.observe(seen, lanes_of(block), moments[snapshot]);
          count(seen, lanes_of(block), snapshot++);
        }
      }
      observer.observe(states, lanes_of(block), moments.back());
      if (records) recorded.hand_over();
      keep(states, block);
    }
  }

  simulated result() {
    out_.final = ensemble_observer::nothing(model_);
    for (auto& s : out_.snapshots) s.moments = ensemble_observer::nothing(model_);
    for (const auto& piece : moments_)
      for (std::size_t i = 0; i < piece.size(); ++i)
        (i < out_.snapshots.size() ? out_.snapshots[i].moments : out_.final).merge(piece[i]);
    if (!noiseless_ && !common_)
      out_.drawn = static_cast<std::uint64_t>(plan_.steps * plan_.bodies * model_.layout().drawn(plan_.with_areas));
    return std::move(out_);
  }

 private:
  int lanes_of(std::int64_t block) const {
    return static_cast<int>(std::min<std::int64_t>(block_lanes, plan_.bodies - block * block_lanes));
  }

  /// After `step`: the next record or snapshot, or the end.
  std::int64_t next_stop(std::int64_t step, std::size_t snapshot) const {
    auto stop = plan_.steps;
    if (snapshot < plan_.snapshots.size()) stop = std::min(stop, plan_.snapshots[snapshot]);
    if (plan_.record_every > 0) stop = std::min(stop, (step / plan_.record_every + 1) * plan_.record_every);
    return stop;
  }

  void start(std::int64_t block, std::vector<double>& states) const {
    const auto first_body = static_cast<std::uint64_t>(block * block_lanes);
    if (orbit_) return orbit_->fill(plan_.seed, first_body, states);
    if (plan_.start == ensemble_start::momentum) {
      states = replicated(plan_.momentum);
      return;
    }
    double radius = 0;
    for (const double x : plan_.momentum) radius = std::hypot(radius, x);
    start_uniformly(plan_.seed, first_body, radius, states);
  }

  void advance(std::vector<double>& states, std::int64_t block, std::int64_t step, std::int64_t steps,
               increment_buffer& noise) const {
    const auto part = [&](std::int64_t from, std::int64_t n) { return piece{from == 0, from + n == plan_.steps}; };
    if (common_) return kernel_.advance(states, *common_, step, steps, part(step, steps));
    if (noiseless_) return kernel_.advance(states, silence(static_cast<int>(steps)), part(step, steps));
    for (std::int64_t done = 0; done < steps; done += chunk) {
      const int n = static_cast<int>(std::min<std::int64_t>(chunk, steps - done));
      const auto view = noise.fill(plan_.seed, static_cast<std::uint64_t>(block * block_lanes),
                                   static_cast<std::uint64_t>(step + done), n, kernel_.dt());
      kernel_.advance(states, view, part(step + done, n));
    }
  }

  /// Counts commute, so one histogram for all threads does, a block at a time.
  void count(std::span<const double> states, int lanes, std::size_t snapshot) {
    direction_bins bins;
    find_bins(states.data() + plan_.pictured * block_lanes, bins);
    auto& out = out_.snapshots[snapshot];
    const std::lock_guard lock(counting_[snapshot]);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
      if (bins.longitude[lane] < 0) continue;
      ++out.counts[static_cast<std::size_t>(bins.longitude[lane])];
      ++out.picture[static_cast<std::size_t>(bins.hemisphere[lane])];
    }
  }

  void keep(std::span<const double> states, std::int64_t block) {
    for (int k = 0; k < model_.dimension(); ++k)
      std::ranges::copy_n(states.begin() + k * block_lanes, lanes_of(block),
                          out_.states.begin() + k * plan_.bodies + block * block_lanes);
  }

  void tell(std::int64_t steps) {
    if (!progress_) return;
    const std::lock_guard lock(telling_);
    done_ += static_cast<double>(steps);
    progress_(done_ / (static_cast<double>(plan_.steps) * static_cast<double>(blocks_of(plan_))));
  }

  const model& model_;
  const kernel& kernel_;
  const simulation_plan& plan_;
  const std::function<void(double)>& progress_;
  double done_ = 0;
  bool noiseless_ = false;
  std::optional<shared_steps> common_;
  std::optional<orbit_start> orbit_;
  std::vector<std::vector<ensemble_moments>> moments_;  // [piece][stop]
  std::vector<std::mutex> counting_;                    // [snapshot]
  std::mutex telling_;
  simulated out_;
};

}  // namespace

simulated simulate_ensemble(const model& m, const kernel& k, const simulation_plan& p,
                            const std::function<void(double)>& progress) {
  ensemble_run run(m, k, p, progress);
  parallel_for(p.threads, run.pieces(), [&](int piece) { run.run_piece(piece); });
  return run.result();
}

double simulation_bytes(const model& m, const simulation_plan& p) {
  const bool common = p.noise == ensemble_noise::common && !m.layout().silent();
  const double states = static_cast<double>(p.bodies) * m.dimension() * sizeof(double);
  const double counts = (longitude_bins::count + hemisphere_bins::count) * sizeof(std::uint32_t);
  const double pieces = static_cast<double>(blocks_of(p)) / static_cast<double>(blocks_a_piece(p)) + 1;
  const double stops = static_cast<double>(p.snapshots.size());
  const double moments = pieces * (stops + 1) * (sizeof(ensemble_moments) + 96.0);
  return states + stops * counts + moments + (common ? shared_bytes(m, p) : 0);
}

}  // namespace polhode
