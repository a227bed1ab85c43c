#include "experiments/stability_run.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "ensemble/paths.hpp"
#include "ensemble/running_moments.hpp"
#include "experiments/sequential.hpp"

namespace polhode {
namespace {

constexpr int most_chunk = 16;     // steps between two looks at the paths
constexpr int most_extension = 4;  // times the planned paths, where the mean energy is near its margin

/// One block of paths and what has broken each of them.
class watched_block {
 public:
  watched_block(const stability_case& c, bool implicit)
      : states(replicated(c.bound.scene.momentum)), case_(c), implicit_(implicit) {}

  std::vector<double> states;
  std::array<breakage, block_lanes> broken{};

  void look(stability_outcome& out) {
    case_.bound.model->conserved(states, energy_, casimir_);
    if (all_whole(out)) return;
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      const auto now = judge(lane, out);
      if (broken[lane] == breakage::none && now != breakage::none) {
        broken[lane] = now;
        ++out.broken;
      }
    }
  }
  double energy(std::size_t lane) const { return energy_[lane]; }

 private:
  const stability_case& case_;
  bool implicit_;
  std::array<double, block_lanes> energy_{}, casimir_{};

  double off(double c) const { return c > 0 ? std::fabs(c - case_.radius) / case_.radius : 1; }
  double beyond(double h) const { return std::max({0.0, h - case_.greatest_energy, case_.least_energy - h}); }

  /// What is nearly always so, by the extremes alone. NaN is in no order, but a sum keeps it.
  bool all_whole(stability_outcome& out) const {
    const Eigen::Map<const Eigen::Array<double, block_lanes, 1>> h(energy_.data()), c(casimir_.data());
    if (!std::isfinite(h.sum() + c.sum())) return false;
    const double worst = std::max(off(c.minCoeff()), off(c.maxCoeff())), most = case_.greatest_energy,
                 excess = std::max(beyond(h.minCoeff()), beyond(h.maxCoeff()));
    if (!(worst <= casimir_share && excess <= energy_share * most)) return false;
    out.worst_casimir = std::max(out.worst_casimir, worst);
    if (most > 0) out.worst_energy = std::max(out.worst_energy, excess / most);
    return true;
  }

  /// |Pi| = 0 is no rounding: its square has vanished, and with it every direction.
  breakage judge(std::size_t lane, stability_outcome& out) const {
    const double h = energy_[lane], c = casimir_[lane];
    if (!std::isfinite(h) || !std::isfinite(c)) {
      if (!implicit_) out.worst_casimir = std::numeric_limits<double>::infinity();
      return implicit_ ? breakage::not_solved : breakage::not_finite;
    }
    const double most = case_.greatest_energy;
    out.worst_casimir = std::max(out.worst_casimir, off(c));
    if (most > 0) out.worst_energy = std::max(out.worst_energy, beyond(h) / most);
    if (off(c) > casimir_share) return breakage::casimir;
    return beyond(h) > energy_share * most ? breakage::energy_range : breakage::none;
  }
};

bool too_many(const stability_outcome& out, int planned) {
  return out.broken > broken_share * std::max(planned, out.paths);
}

breakage most_frequent(const std::array<int, 6>& counts) {
  return static_cast<breakage>(std::ranges::max_element(counts.begin() + 1, counts.end()) - counts.begin());
}

/// By how much the mean energy is off beyond what it may; absent where it has no reference.
std::optional<double> beyond_margin(const stability_case& c, double mean) {
  if (!c.mean_energy) return std::nullopt;
  return std::fabs(mean - *c.mean_energy) - mean_energy_share * (c.greatest_energy - c.least_energy);
}

/// Whether so many paths cannot tell on which side of its margin the mean energy is.
bool undecided(const stability_case& c, const running_moments& energy) {
  const auto beyond = beyond_margin(c, energy.mean);
  return beyond && std::fabs(*beyond) < 2 * energy.deviation() / std::sqrt(static_cast<double>(energy.count));
}

running_moments energy_of_whole(const watched_block& b) {
  std::vector<double> energies;
  for (std::size_t lane = 0; lane < block_lanes; ++lane)
    if (b.broken[lane] == breakage::none) energies.push_back(b.energy(lane));
  return running_moments::of(energies);
}

/// One run, block by block and chunk by chunk: who drives it brings the noise.
class watched_run {
 public:
  watched_run(const stability_case& in, const kernel& step, bool implicit, bool areas, double dt, block_listener hear,
              const stability_plan& p)
      : case_(in), step_(step), implicit_(implicit), areas_(areas), dt_(dt), hear_(std::move(hear)), plan_(p) {}

  bool wants(int block) const {
    if (!plan_.to_the_end && too_many(out_, plan_.paths)) return false;
    const int planned = blocks_of(plan_.paths), most = plan_.to_the_end ? planned : most_extension * planned;
    return block < planned || (block < most && undecided(case_, energy_));
  }
  void begin() {
    block_.emplace(case_, implicit_);
    before_ = out_.broken;
    over_ = false;
  }
  /// Nothing more can be learned from this block.
  bool over() const { return over_; }
  double dt() const { return dt_; }
  bool needs_areas() const { return areas_; }

  void advance(std::int64_t first_step, const increment_view& view) {
    if (hear_ && !view.silent()) hear_(first_step, view);
    step_.advance(block_->states, view);
    block_->look(out_);
    over_ = out_.broken - before_ == block_lanes || (!plan_.to_the_end && too_many(out_, plan_.paths));
  }
  void end() {
    out_.paths += block_lanes;
    for (const auto broken : block_->broken) ++counts_[static_cast<std::size_t>(broken)];
    energy_.merge(energy_of_whole(*block_));
  }

  stability_outcome outcome() const {
    auto out = out_;
    out.mean_energy = energy_.mean;
    if (too_many(out, plan_.paths))
      out.first = most_frequent(counts_);
    else if (const auto beyond = beyond_margin(case_, out.mean_energy); beyond && !(*beyond <= 0))
      out.first = breakage::mean_energy;
    return out;
  }

 private:
  const stability_case& case_;
  const kernel& step_;
  bool implicit_, areas_;
  double dt_;
  block_listener hear_;
  const stability_plan& plan_;
  stability_outcome out_;
  std::array<int, 6> counts_{};
  running_moments energy_;
  std::optional<watched_block> block_;
  int before_ = 0;
  bool over_ = false;
};

/// Normals of a block through a chunk of steps, for any dt.
class common_normals {
 public:
  common_normals(const model& m, const stability_plan& p, int chunk)
      : plan_(p),
        silent_(m.active_channels() == 0),
        increments_(m, chunk, false, {p.generator, noise_quality::fast}),
        both_(m, chunk, true, {p.generator, noise_quality::fast}) {}

  /// The number of steps names the run: 2^24 paths each, and no two numbers of steps share one.
  void fill(int block, std::int64_t first_step, int steps, bool areas) {
    const auto path = (static_cast<std::uint64_t>(plan_.steps) << 24) + static_cast<std::uint64_t>(block) * block_lanes;
    view_ = silent_ ? silence(steps, 1)
                    : (areas ? both_ : increments_)
                          .fill(plan_.seed, path, static_cast<std::uint64_t>(first_step), steps, normal_area_dt);
  }
  increment_view scaled_to(double dt, bool areas) {
    if (silent_) return silence(view_.steps, dt);
    if (!areas) return {dt, view_.steps, {}, {}, view_.singles, std::sqrt(dt)};
    area_.resize(view_.area.size());
    std::ranges::transform(view_.area, area_.begin(), [scale = dt / normal_area_dt](double x) { return scale * x; });
    return {dt, view_.steps, {}, area_, view_.singles, std::sqrt(dt)};
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
void run(const model& m, const stability_plan& p, std::vector<watched_run>& runs) {
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

std::string_view name_of(breakage b) {
  constexpr std::array<std::string_view, 6> names{"nothing", "step not solved", "not finite",
                                                  "Casimir", "energy range",    "mean energy"};
  return names[static_cast<std::size_t>(b)];
}

std::vector<stability_outcome> run_until_broken(std::span<const stability_member> members, const stability_plan& p) {
  std::vector<std::unique_ptr<kernel>> kernels;
  std::vector<watched_run> runs;
  for (const auto& m : members) {
    kernels.push_back(m.scheme->make(m.dt));
    runs.emplace_back(*m.in, *kernels.back(), m.scheme->info.implicit, m.scheme->needs_areas, m.dt, m.hear, p);
  }
  run(*members.front().in->bound.model, p, runs);
  std::vector<stability_outcome> out;
  for (const auto& r : runs) out.push_back(r.outcome());
  return out;
}

stability_outcome run_until_broken(const stability_case& c, const scheme_entry& scheme, const stability_plan& p) {
  const stability_member alone{&c, &scheme, p.dt, p.hear};
  return run_until_broken({&alone, 1}, p).front();
}

double fine_mean_energy(const stability_case& c, int paths, std::uint64_t seed, noise_generator generator,
                        const block_listener& hear) {
  constexpr double resolution = 16;
  const auto steps = static_cast<std::int64_t>(std::ceil(resolution * c.rate * c.horizon));
  const auto reference = c.bound.model->reference();
  // A seed of its own: a scheme that happens to take as many steps must not see the same paths.
  const stability_plan p{c.horizon / static_cast<double>(steps), steps, paths, ~seed, generator, true, hear};
  std::vector<watched_run> alone;
  alone.emplace_back(c, *reference, false, false, p.dt, hear, p);
  run(*c.bound.model, p, alone);
  return alone.front().outcome().mean_energy;
}

}  // namespace polhode
