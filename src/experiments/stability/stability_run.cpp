// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/stability/watched_run.hpp"

namespace polhode {
namespace {

constexpr int most_chunk = 16;  // steps between two looks at the paths

/// Normals of a block through a chunk of steps, for any dt.
class common_normals {
 public:
  common_normals(const model& m, const stability_plan& p, int chunk)
      : plan_(p),
        silent_(m.layout().silent()),
        increments_(m, chunk, false, {p.generator, noise_quality::fast}),
        both_(m, chunk, true, {p.generator, noise_quality::fast}) {}

  /// The number of steps names the run: 2^24 paths each, and no two numbers of steps share one.
  void fill(int block, std::int64_t first_step, int steps, bool areas) {
    const auto path = (static_cast<std::uint64_t>(plan_.steps) << 24) + static_cast<std::uint64_t>(block) * block_lanes;
    view_ = silent_ ? silence(steps)
                    : (areas ? both_ : increments_)
                          .fill(plan_.seed, path, static_cast<std::uint64_t>(first_step), steps, normal_area_dt);
  }
  increment_view scaled_to(double dt, bool areas) {
    if (silent_) return silence(view_.steps);
    if (!areas) return {view_.steps, {}, {}, view_.singles, std::sqrt(dt)};
    area_.resize(view_.area.size());
    std::ranges::transform(view_.area, area_.begin(), [scale = dt / normal_area_dt](double x) { return scale * x; });
    return {view_.steps, {}, area_, view_.singles, std::sqrt(dt)};
  }

 private:
  static constexpr double normal_area_dt = 2;  // areas have the variance dt^2/4
  const stability_plan& plan_;
  bool silent_;
  increment_buffer increments_, both_;
  increment_view view_;
  lane_vector<double> area_;
};

void run_block(const stability_plan& p, int chunk, int block, common_normals& noise, std::vector<watched_run*> open) {
  for (auto* r : open) r->begin();
  auto within = open;
  for (std::int64_t i = 0; i < p.steps && !within.empty(); i += chunk) {
    noise.fill(block, i, static_cast<int>(std::min<std::int64_t>(chunk, p.steps - i)),
               std::ranges::any_of(within, &watched_run::needs_areas));
    for (auto* r : within) r->advance(i, noise.scaled_to(r->dt(), r->needs_areas()));
    std::erase_if(within, [](const watched_run* r) { return r->over(); });
  }
  for (auto* r : open) r->end();
}

/// All of the same noise.
void run_watched(const model& m, const stability_plan& p, std::vector<watched_run>& runs) {
  const auto chunk = static_cast<int>(std::clamp<std::int64_t>(p.steps / 64, 1, most_chunk));
  common_normals noise(m, p, chunk);
  for (int block = 0;; ++block) {
    std::vector<watched_run*> open;
    for (auto& r : runs)
      if (r.wants(block)) open.push_back(&r);
    if (open.empty()) return;
    run_block(p, chunk, block, noise, std::move(open));
  }
}

}  // namespace

std::vector<stability_outcome> run_until_broken(std::span<const stability_member> members, const stability_plan& p) {
  std::vector<std::unique_ptr<kernel>> kernels;
  std::vector<watched_run> runs;
  for (const auto& m : members) {
    kernels.push_back(m.scheme->make(m.dt));
    runs.emplace_back(*m.in, *kernels.back(), m.scheme->info.implicit, m.scheme->needs_areas, m.hear, p);
  }
  run_watched(*members.front().in->bound.model, p, runs);
  std::vector<stability_outcome> out;
  for (const auto& r : runs) out.push_back(r.outcome());
  return out;
}

stability_outcome run_until_broken(const stability_case& c, const scheme_entry& scheme, const stability_plan& p) {
  const stability_member alone{&c, &scheme, p.dt, p.hear};
  return run_until_broken({&alone, 1}, p).front();
}

stability_outcome true_paths(const stability_case& c, int paths, std::uint64_t seed, noise_generator generator,
                             const block_listener& hear) {
  constexpr double resolution = 16;
  const auto steps = static_cast<std::int64_t>(std::ceil(resolution * c.rate * c.horizon));
  // A seed of its own: a scheme that happens to take as many steps must not see the same paths.
  const stability_plan p{c.horizon / static_cast<double>(steps), steps, paths, ~seed, generator, true, hear};
  const auto reference = c.bound.model->reference(p.dt);
  std::vector<watched_run> alone;
  alone.emplace_back(c, *reference, false, false, hear, p);
  run_watched(*c.bound.model, p, alone);
  return alone.front().outcome();
}

}  // namespace polhode
