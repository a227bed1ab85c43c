// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/watched_run.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/sequential.hpp"

namespace polhode {
namespace {

constexpr double close = 1e-12;    // of a Casimir, on an orbit that is not compact: beyond, paths are looked at singly
constexpr int most_extension = 4;  // times the planned paths, where the mean energy is near its margin

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

}  // namespace

void watched_block::look(stability_outcome& out) {
  case_.bound.model->conserved(states, energy_, casimirs_);
  if (all_whole(out)) return;
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    const auto now = judge(lane, out);
    if (broken[lane] == breakage::none && now != breakage::none) {
      broken[lane] = now;
      ++out.broken;
    }
  }
}

double watched_block::off(std::size_t i, double c) const {
  if (case_.bounded && !(c > 0)) return 1;
  return std::fabs(c - case_.casimirs[i]) / case_.casimir_sizes[i];
}

double watched_block::off(std::size_t lane) const {
  double worst = 0;
  const auto& m = *case_.bound.model;
  std::vector<double> now;
  if (!case_.compact) now = m.casimir_sizes(lane_of(states, static_cast<int>(lane), m.dimension()));
  for (std::size_t i = 0; i < case_.casimirs.size(); ++i) {
    const double grown = case_.compact ? 1 : std::min(1.0, case_.casimir_sizes[i] / now[i]);
    const double one = off(i, casimirs_[i * block_lanes + lane]) * grown;
    worst = std::isnan(one) ? one : std::max(worst, one);
    if (std::isnan(worst)) break;
  }
  return worst;
}

double watched_block::beyond(double h) const {
  return case_.bounded ? std::max({0.0, h - case_.greatest_energy, case_.least_energy - h}) : 0;
}

bool watched_block::all_whole(stability_outcome& out) const {
  using lanes = Eigen::Map<const Eigen::Array<double, block_lanes, 1>>;
  const lanes h(energy_.data());
  double sum = h.sum(), worst = 0;
  for (std::size_t i = 0; i < case_.casimirs.size(); ++i) {
    const lanes c(casimirs_.data() + i * block_lanes);
    sum += c.sum();
    worst = std::max({worst, off(i, c.minCoeff()), off(i, c.maxCoeff())});
  }
  if (!std::isfinite(sum)) return false;
  const double least = h.minCoeff(), greatest = h.maxCoeff(), most = case_.energy_size(),
               excess = std::max(beyond(least), beyond(greatest));
  if (!(worst <= (case_.compact ? casimir_share : close) && excess <= energy_share * most)) return false;
  out.see(least, greatest);
  out.worst_casimir = std::max(out.worst_casimir, worst);
  if (most > 0) out.worst_energy = std::max(out.worst_energy, excess / most);
  return true;
}

breakage watched_block::judge(std::size_t lane, stability_outcome& out) const {
  const double h = energy_[lane], apart = off(lane);
  if (!std::isfinite(h) || !std::isfinite(apart)) {
    if (!implicit_ && case_.bounded) out.worst_casimir = std::numeric_limits<double>::infinity();
    return implicit_ ? breakage::not_solved : breakage::not_finite;
  }
  const double most = case_.energy_size();
  if (case_.bounded || (broken[lane] == breakage::none && apart <= casimir_share))
    out.worst_casimir = std::max(out.worst_casimir, apart);
  if (most > 0) out.worst_energy = std::max(out.worst_energy, beyond(h) / most);
  if (apart > casimir_share) return breakage::casimir;
  if (broken[lane] == breakage::none) out.see(h, h);
  return beyond(h) > energy_share * most ? breakage::energy_range : breakage::none;
}

watched_run::watched_run(const stability_case& in, const kernel& step, bool implicit, bool areas, block_listener hear,
                         const stability_plan& p)
    : case_(in), step_(step), implicit_(implicit), areas_(areas), hear_(std::move(hear)), plan_(p) {}

bool watched_run::wants(int block) const {
  if (!plan_.to_the_end && too_many(out_, plan_.paths)) return false;
  const int planned = blocks_of(plan_.paths), most = plan_.to_the_end ? planned : most_extension * planned;
  return block < planned || (block < most && undecided(case_, energy_));
}

void watched_run::begin() {
  block_.emplace(case_, implicit_);
  before_ = out_.broken;
  over_ = false;
}

void watched_run::advance(std::int64_t first_step, const increment_view& view) {
  if (hear_ && !view.silent()) hear_(first_step, view, dt());
  step_.advance(block_->states, view);
  block_->look(out_);
  over_ = out_.broken - before_ == block_lanes || (!plan_.to_the_end && too_many(out_, plan_.paths));
}

void watched_run::end() {
  out_.paths += block_lanes;
  for (const auto broken : block_->broken) ++counts_[static_cast<std::size_t>(broken)];
  energy_.merge(energy_of_whole(*block_));
}

stability_outcome watched_run::outcome() const {
  auto out = out_;
  out.mean_energy = energy_.mean;
  if (too_many(out, plan_.paths))
    out.first = most_frequent(counts_);
  else if (const auto beyond = beyond_margin(case_, out.mean_energy); beyond && !(*beyond <= 0))
    out.first = breakage::mean_energy;
  return out;
}

}  // namespace polhode
