// SPDX-License-Identifier: Apache-2.0
#include "ensemble/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <shared_mutex>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/observing/block_record.hpp"
#include "ensemble/observing/direction_bins.hpp"
#include "ensemble/observing/sphere_bins.hpp"
#include "ensemble/orbit_start.hpp"
#include "ensemble/uniform_start.hpp"

namespace polhode {
namespace {

constexpr int chunk = 16;  // steps of a block's own increments: they stay in the nearest caches

std::int64_t blocks_of(const simulation_plan& p) { return (p.bodies + block_lanes - 1) / block_lanes; }

/// Blocks that one thread takes at a time: by the ensemble alone, as sums are merged piece by piece. More of them where
/// the pieces' moments would fill the memory.
std::int64_t blocks_a_piece(const simulation_plan& p) {
  const auto blocks = blocks_of(p);
  return std::clamp<std::int64_t>(blocks / 1024, 1, std::max<std::int64_t>(64, blocks / 65'536));
}

/// Increments, and the table that the kernel makes of them: a row a step, as wide as in the table of no steps.
double shared_bytes(const model& m, const kernel& k, const simulation_plan& p) {
  const double row = static_cast<double>(k.share(silence(0)).words * sizeof(double));
  return shared_increments::bytes(m, p.steps, p.with_areas) + static_cast<double>(p.steps) * row;
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
      drawn_ = drawn.drawn();
    }
    at_.bodies = p.bodies;
    at_.blocks_a_piece = blocks_a_piece(p);
    if (p.keep_states) at_.states.resize(static_cast<std::size_t>(m.dimension()) * static_cast<std::size_t>(p.bodies));
    at_.snapshots.resize(p.snapshots.size());
    for (auto& s : at_.snapshots) {
      s.counts.resize(longitude_bins::count);
      s.picture.resize(hemisphere_bins::count);
    }
    at_.pieces.resize(static_cast<std::size_t>((blocks_of(p) + at_.blocks_a_piece - 1) / at_.blocks_a_piece));
    for (auto& one : at_.pieces) one.moments.assign(p.snapshots.size() + 1, ensemble_observer::nothing(model_));
    if (p.resume) p.resume(at_);
    done_ = at_.steps_done(p.steps);
  }

  /// Of this rank.
  int pieces() const { return (static_cast<int>(at_.pieces.size()) - plan_.rank + plan_.ranks - 1) / plan_.ranks; }

  void run_piece(int piece) {
    const auto number = static_cast<std::size_t>(piece * plan_.ranks + plan_.rank);
    increment_buffer noise(model_, chunk, plan_.with_areas, plan_.source);
    ensemble_observer observer(model_, plan_.momentum);
    block_record recorded(model_.dimension(), plan_.record);
    auto& own = at_.pieces[number];
    const auto first = static_cast<std::int64_t>(number) * at_.blocks_a_piece;
    while (own.block < at_.blocks_of(number)) {
      for (bool done = false; !done;) {
        {
          const auto at_work = take_part();
          done = advance_to_stop(own, first + own.block, noise, observer, recorded);
        }
        save_if_due();
      }
    }
  }

  simulated result() {
    if (plan_.join) plan_.join(at_);
    simulated out{std::move(at_.states), ensemble_observer::nothing(model_), {}, drawn_};
    for (auto& s : at_.snapshots) out.snapshots.push_back({std::move(s), ensemble_observer::nothing(model_)});
    for (const auto& piece : at_.pieces)
      for (std::size_t i = 0; i < piece.moments.size(); ++i)
        (i < out.snapshots.size() ? out.snapshots[i].moments : out.final).merge(piece.moments[i]);
    if (!noiseless_ && !common_)
      out.drawn = static_cast<std::uint64_t>(plan_.steps * plan_.bodies * model_.layout().drawn(plan_.with_areas));
    return out;
  }

 private:
  int lanes_of(std::int64_t block) const {
    return static_cast<int>(std::min<std::int64_t>(block_lanes, plan_.bodies - block * block_lanes));
  }

  /// After `step`: the next record or snapshot, the end of a slice, or of the run.
  std::int64_t next_stop(std::int64_t step, std::size_t snapshot) const {
    auto stop = std::min(plan_.steps, step + plan_.slice);
    if (snapshot < plan_.snapshots.size()) stop = std::min(stop, plan_.snapshots[snapshot]);
    if (plan_.record_every > 0) stop = std::min(stop, (step / plan_.record_every + 1) * plan_.record_every);
    return stop;
  }

  /// Of one block; true where that is its end: `own` is at the next block then.
  bool advance_to_stop(piece_progress& own, std::int64_t block, increment_buffer& noise, ensemble_observer& observer,
                       block_record& recorded) {
    const bool records = plan_.record_every > 0;
    if (own.step == 0) {
      start(block, own.states);
      if (records) {
        recorded.start(block * block_lanes, lanes_of(block));
        recorded.add(own.states);
      }
    }
    const auto past = std::ranges::upper_bound(plan_.snapshots, own.step);
    auto snapshot = static_cast<std::size_t>(past - plan_.snapshots.begin());
    const auto stop = next_stop(own.step, snapshot);
    advance(own.states, block, own.step, stop - own.step, noise);
    tell(stop - own.step);
    own.step = stop;
    const bool pictured = snapshot < plan_.snapshots.size() && stop == plan_.snapshots[snapshot];
    if (pictured || (records && stop % plan_.record_every == 0)) {
      auto seen = own.states;
      if (stop < plan_.steps) kernel_.finish(seen);
      if (records && stop % plan_.record_every == 0) recorded.add(seen);
      if (pictured) {
        observer.observe(seen, lanes_of(block), own.moments[snapshot]);
        count(seen, lanes_of(block), snapshot);
      }
    }
    if (stop < plan_.steps) return false;
    observer.observe(own.states, lanes_of(block), own.moments.back());
    if (records) recorded.hand_over();
    keep(own.states, block);
    own.states.clear();
    own.step = 0;
    ++own.block;
    return true;
  }

  void start(std::int64_t block, std::vector<double>& states) const {
    const auto first_body = static_cast<std::uint64_t>(block * block_lanes);
    states = replicated(plan_.momentum);
    if (orbit_) return orbit_->fill(plan_.seed, first_body, states);
    if (plan_.start == ensemble_start::momentum) return;
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
    auto& out = at_.snapshots[snapshot];
    const std::lock_guard lock(counting_[snapshot]);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
      if (bins.longitude[lane] < 0) continue;
      ++out.counts[static_cast<std::size_t>(bins.longitude[lane])];
      ++out.picture[static_cast<std::size_t>(bins.hemisphere[lane])];
    }
  }

  void keep(std::span<const double> states, std::int64_t block) {
    if (!plan_.keep_states) return;
    for (int k = 0; k < model_.dimension(); ++k)
      std::ranges::copy_n(states.begin() + k * block_lanes, lanes_of(block),
                          at_.states.begin() + k * plan_.bodies + block * block_lanes);
  }

  /// Held from one stop to the next, by several threads at once; none is while the whole is saved.
  std::shared_lock<std::shared_mutex> take_part() {
    const std::lock_guard in_turn(turnstile_);
    return std::shared_lock(whole_);
  }

  void save_if_due() {
    if (!plan_.save || !plan_.save_due()) return;
    const std::lock_guard in_turn(turnstile_);
    const std::lock_guard alone(whole_);
    if (plan_.save_due()) plan_.save(at_);
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
  std::uint64_t drawn_ = 0;
  std::optional<shared_steps> common_;
  std::optional<orbit_start> orbit_;
  ensemble_progress at_;
  std::vector<std::mutex> counting_;  // [snapshot]
  std::mutex telling_, turnstile_;
  std::shared_mutex whole_;
};

}  // namespace

simulated simulate_ensemble(const model& m, const kernel& k, const simulation_plan& p,
                            const std::function<void(double)>& progress) {
  ensemble_run run(m, k, p, progress);
  parallel_for(p.threads, run.pieces(), [&](int piece) { run.run_piece(piece); });
  return run.result();
}

double simulation_bytes(const model& m, const kernel& k, const simulation_plan& p) {
  const bool common = p.noise == ensemble_noise::common && !m.layout().silent();
  const double states = p.keep_states ? static_cast<double>(p.bodies) * m.dimension() * sizeof(double) : 0;
  const double counts = (longitude_bins::count + hemisphere_bins::count) * sizeof(std::uint32_t);
  const double pieces = static_cast<double>(blocks_of(p)) / static_cast<double>(blocks_a_piece(p)) + 1;
  const double stops = static_cast<double>(p.snapshots.size());
  const double moments = pieces * (stops + 1) * (sizeof(ensemble_moments) + 96.0);
  return states + stops * counts + moments + (common ? shared_bytes(m, k, p) : 0);
}

}  // namespace polhode
