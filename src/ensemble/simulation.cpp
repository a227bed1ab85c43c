#include "ensemble/simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>

#include "ensemble/paths.hpp"
#include "ensemble/shared_increments.hpp"
#include "ensemble/sphere_bins.hpp"

namespace polhode {
namespace {

constexpr int chunk = 16;                       // steps of a block's own increments: they stay in the nearest caches
constexpr std::int64_t longest_slice = 65'536;  // steps between two words on progress

std::int64_t blocks_of(const simulation_plan& p) { return (p.bodies + block_lanes - 1) / block_lanes; }

/// Blocks that one thread takes at a time: by the ensemble alone, as sums are merged piece by piece.
std::int64_t blocks_a_piece(const simulation_plan& p) { return std::clamp<std::int64_t>(blocks_of(p) / 1024, 1, 64); }

std::vector<double> start_of(const simulation_plan& p, std::int64_t block) {
  if (p.start == ensemble_start::momentum) return replicated(p.momentum);
  double radius = 0;
  for (const double x : p.momentum) radius = std::hypot(radius, x);
  std::vector<double> states(3 * block_lanes);
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto path = static_cast<std::uint64_t>(block * block_lanes + lane);
    const auto x = normals<3>({p.seed, noise_kind::initial_state, path, 0});
    const double length = std::sqrt(dot(x, x));
    for (int k = 0; k < 3; ++k) states[static_cast<std::size_t>(k * block_lanes + lane)] = radius * x[k] / length;
  }
  return states;
}

/// Everything that the pieces share.
class ensemble_run {
 public:
  ensemble_run(const model& m, const kernel& k, const simulation_plan& p, const std::function<void(double)>& progress)
      : model_(m), kernel_(k), plan_(p), progress_(progress), observer_(m, p.momentum) {
    noiseless_ = p.noise == ensemble_noise::none || m.active_channels() == 0;
    if (!noiseless_ && p.noise == ensemble_noise::common)
{
      common_.emplace(m, p.seed, p.steps, p.dt, p.with_areas, p.threads);
      common_steps_ = k.share(common_->view(0, static_cast<int>(p.steps)));
    }
    out_.states.resize(static_cast<std::size_t>(m.dimension()) * static_cast<std::size_t>(p.bodies));
    out_.snapshots.resize(p.snapshots.size());
    for (auto& s : out_.snapshots) {
      s.counts.resize(longitude_bins::count);
      s.picture.resize(hemisphere_bins::count);
    }
    moments_.resize(static_cast<std::size_t>(pieces()),
                    std::vector<ensemble_moments>(p.snapshots.size() + 1, observer_.nothing()));
  }

  int pieces() const {
    return static_cast<int>((blocks_of(plan_) + blocks_a_piece(plan_) - 1) / blocks_a_piece(plan_));
  }

  void run_piece(int piece) {
    increment_buffer noise(model_, chunk, plan_.with_areas);
    std::vector<std::vector<direction_bins>> seen(plan_.snapshots.size());
    const std::int64_t first = piece * blocks_a_piece(plan_);
    for (auto block = first; block < std::min(first + blocks_a_piece(plan_), blocks_of(plan_)); ++block) {
      auto states = start_of(plan_, block);
      std::int64_t step = 0;
      for (std::size_t i = 0; i <= plan_.snapshots.size(); ++i) {
        const bool last = i == plan_.snapshots.size();
        for (const auto stop = last ? plan_.steps : plan_.snapshots[i]; step < stop;) {
          const auto n = std::min(stop - step, longest_slice);
          advance(states, block, step, n, noise);
          step += n;
          tell(n);
        }
        auto seen_now = states;
        if (!last) kernel_.finish(seen_now, plan_.dt);
        observer_.observe(seen_now, lanes_of(block), moments_[static_cast<std::size_t>(piece)][i],
                          last ? nullptr : &seen[i]);
      }
      keep(states, block);
    }
    count(seen);
  }

  simulated result() {
    out_.final = observer_.nothing();
    for (auto& s : out_.snapshots) s.moments = observer_.nothing();
    for (const auto& piece : moments_)
      for (std::size_t i = 0; i < piece.size(); ++i)
        (i < out_.snapshots.size() ? out_.snapshots[i].moments : out_.final).merge(piece[i]);
    if (common_) out_.drawn = common_->drawn();
    if (!noiseless_ && !common_) out_.drawn = static_cast<std::uint64_t>(plan_.steps * plan_.bodies * rows_drawn());
    return std::move(out_);
  }

 private:
  std::int64_t rows_drawn() const {
    const int m = model_.active_channels(), all = model_.channels();
    return m + (plan_.with_areas && m > 1 ? all * (all - 1) / 2 : 0);
  }
  int lanes_of(std::int64_t block) const {
    return static_cast<int>(std::min<std::int64_t>(block_lanes, plan_.bodies - block * block_lanes));
  }

  void advance(std::vector<double>& states, std::int64_t block, std::int64_t step, std::int64_t steps,
               increment_buffer& noise) const {
    const auto part = [&](std::int64_t from, std::int64_t n) { return piece{from == 0, from + n == plan_.steps}; };
    if (common_) return kernel_.advance(states, common_steps_, step, steps, part(step, steps));
    if (noiseless_)
      return kernel_.advance(states, silence(static_cast<int>(steps), plan_.dt), part(step, steps));
    for (std::int64_t done = 0; done < steps; done += chunk) {
      const int n = static_cast<int>(std::min<std::int64_t>(chunk, steps - done));
      const auto view = noise.fill(plan_.seed, static_cast<std::uint64_t>(block * block_lanes),
                                   static_cast<std::uint64_t>(step + done), n, plan_.dt);
      kernel_.advance(states, view, part(step + done, n));
    }
  }

  /// Counts commute, so one histogram for all threads does, filled a piece at a time.
  void count(const std::vector<std::vector<direction_bins>>& seen) {
    const std::lock_guard lock(counting_);
    for (std::size_t i = 0; i < seen.size(); ++i)
      for (const auto& d : seen[i]) {
        ++out_.snapshots[i].counts[d.longitude];
        ++out_.snapshots[i].picture[d.hemisphere];
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
  ensemble_observer observer_;
  double done_ = 0;
  bool noiseless_ = false;
  std::optional<shared_increments> common_;
  shared_steps common_steps_;
  std::vector<std::vector<ensemble_moments>> moments_;  // [piece][stop]
  std::mutex counting_, telling_;
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
  const bool common = p.noise == ensemble_noise::common && m.active_channels() > 0;
  const double states = static_cast<double>(p.bodies) * m.dimension() * sizeof(double);
  const double counts = (longitude_bins::count + hemisphere_bins::count) * sizeof(std::uint32_t);
  const double pieces = static_cast<double>(blocks_of(p)) / static_cast<double>(blocks_a_piece(p)) + 1;
  const double stops = static_cast<double>(p.snapshots.size());
  const double moments = pieces * (stops + 1) * (sizeof(ensemble_moments) + 96.0);
  return states + stops * counts + moments + (common ? shared_increments::bytes(m, p.steps, p.with_areas) : 0);
}

}  // namespace polhode
