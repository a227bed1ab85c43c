#include "experiments/stability_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "ensemble/paths.hpp"
#include "ensemble/running_moments.hpp"
#include "experiments/sequential.hpp"

namespace polhode {
namespace {

constexpr int most_chunk = 16;     // steps between two looks at the paths
constexpr int most_extension = 4;  // times the planned paths, where the mean energy is near its margin

/// What drives a block: a scheme or the reference.
struct stepper {
  const kernel& step;
  bool needs_areas, implicit;
};

/// One block of paths and what has broken each of them.
class watched_block {
 public:
  watched_block(const stability_case& c, bool implicit)
      : states(replicated(c.bound.scene.momentum)), case_(c), implicit_(implicit) {}

  std::vector<double> states;
  std::array<breakage, block_lanes> broken{};

  void look(stability_outcome& out) {
    case_.bound.model->conserved(states, energy_, casimir_);
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

  /// |Pi| = 0 is no rounding: its square has vanished, and with it every direction.
  breakage judge(std::size_t lane, stability_outcome& out) const {
    const double h = energy_[lane], c = casimir_[lane];
    if (!std::isfinite(h) || !std::isfinite(c)) {
      if (!implicit_) out.worst_casimir = std::numeric_limits<double>::infinity();
      return implicit_ ? breakage::not_solved : breakage::not_finite;
    }
    const double off = c > 0 ? std::fabs(c - case_.radius) / case_.radius : 1;
    const double most = case_.greatest_energy;
    const double beyond = std::max({0.0, h - most, case_.least_energy - h});
    out.worst_casimir = std::max(out.worst_casimir, off);
    if (most > 0) out.worst_energy = std::max(out.worst_energy, beyond / most);
    if (off > casimir_share) return breakage::casimir;
    return beyond > energy_share * most ? breakage::energy_range : breakage::none;
  }
};

bool too_many(const stability_outcome& out, int planned) {
  return out.broken > broken_share * std::max(planned, out.paths);
}

void run_block(const stability_case& c, const stepper& s, const stability_plan& p, int block, watched_block& b,
               stability_outcome& out) {
  const auto& m = *c.bound.model;
  const auto chunk = std::clamp<std::int64_t>(p.steps / 64, 1, most_chunk);
  increment_buffer noise(m, static_cast<int>(chunk), s.needs_areas, {p.generator, noise_quality::fast});
  // The number of steps names the run: 2^24 paths each, and no two runs share one.
  const auto first_path = (static_cast<std::uint64_t>(p.steps) << 24) + static_cast<std::uint64_t>(block) * block_lanes;
  const int before = out.broken;
  for (std::int64_t i = 0; i < p.steps; i += chunk) {
    const int n = static_cast<int>(std::min(chunk, p.steps - i));
    const auto view = m.active_channels() > 0 ? noise.fill(p.seed, first_path, static_cast<std::uint64_t>(i), n, p.dt)
                                              : silence(n, p.dt);
    if (p.hear && !view.silent()) p.hear(i, view);
    s.step.advance(b.states, view);
    b.look(out);
    if (out.broken - before == block_lanes || (!p.to_the_end && too_many(out, p.paths))) return;
  }
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

stability_outcome run(const stability_case& c, const stepper& s, const stability_plan& p) {
  stability_outcome out;
  std::array<int, 6> counts{};
  running_moments energy;
  const int planned = blocks_of(p.paths), most = p.to_the_end ? planned : most_extension * planned;
  for (int block = 0; block < planned || (block < most && undecided(c, energy)); ++block) {
    watched_block b(c, s.implicit);
    run_block(c, s, p, block, b, out);
    out.paths += block_lanes;
    for (const auto broken : b.broken) ++counts[static_cast<std::size_t>(broken)];
    energy.merge(energy_of_whole(b));
    if (!p.to_the_end && too_many(out, p.paths)) break;
  }
  out.mean_energy = energy.mean;
  if (too_many(out, p.paths))
    out.first = most_frequent(counts);
  else if (const auto beyond = beyond_margin(c, out.mean_energy); beyond && !(*beyond <= 0))
    out.first = breakage::mean_energy;
  return out;
}

}  // namespace

std::string_view name_of(breakage b) {
  constexpr std::array<std::string_view, 6> names{"nothing", "step not solved", "not finite",
                                                  "Casimir", "energy range",    "mean energy"};
  return names[static_cast<std::size_t>(b)];
}

stability_outcome run_until_broken(const stability_case& c, const scheme_entry& scheme, const stability_plan& p) {
  return run(c, {*scheme.make(p.dt), scheme.needs_areas, scheme.info.implicit}, p);
}

double fine_mean_energy(const stability_case& c, int paths, std::uint64_t seed, noise_generator generator,
                        const block_listener& hear) {
  constexpr double resolution = 16;
  const auto steps = static_cast<std::int64_t>(std::ceil(resolution * c.rate * c.horizon));
  const auto reference = c.bound.model->reference();
  // A seed of its own: a scheme that happens to take as many steps must not see the same paths.
  return run(c, {*reference, false, false},
             {c.horizon / static_cast<double>(steps), steps, paths, ~seed, generator, true, hear})
      .mean_energy;
}

}  // namespace polhode
