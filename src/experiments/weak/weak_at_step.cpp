// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/weak_at_step.hpp"

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/weak/twin_chain.hpp"

namespace polhode {
namespace {

constexpr int twin_cells = 4;           // of the truth in the finest of the twins' steps
constexpr double twin_resolution = 16;  // of the fastest time scale: that step
constexpr noise_quality precise = noise_quality::precise;

/// At least two levels, the step itself the coarsest.
level_grid grid_for(double horizon, int steps, double rate) {
  level_grid out{horizon, {steps, 2 * steps}};
  while (horizon / out.steps.back() * rate > 1 / twin_resolution) out.steps.push_back(2 * out.steps.back());
  return out;
}

driven_kernels without_directions(const subject& s, const level_grid& grid) {
  const auto dt = grid.dt();
  driven_kernels out{s.model->reference(dt.back() / twin_cells), {}, {}};
  for (const double step : dt) out.twins.push_back(s.model->reference(step));
  return out;
}

std::vector<int> looks_of(int steps) {
  std::vector<int> out;
  const int count = std::min(steps, weak_at_step::most_times);
  for (int i = 1; i <= count; ++i) out.push_back(steps * i / count);
  return out;
}

}  // namespace

weak_at_step::weak_at_step(const context& c, std::uint64_t seed, const std::vector<observable>& f, double horizon,
                           int steps, double rate, int most_paths)
    : context_(c),
      observables_(f),
      grid_(grid_for(horizon, steps, rate)),
      cells_in_a_step_(grid_.steps.back() / steps * twin_cells),
      driven_(without_directions(c.subject, grid_)),
      looks_(looks_of(steps)),
      controls_(c.subject.model->layout(), static_cast<int>(looks_.size()), horizon, most_paths),
      truth_(static_cast<std::size_t>(most_paths / block_lanes)) {
  context_.seed = seed;
  for (const int look : looks_) times_.push_back(horizon * look / steps);
}

double weak_at_step::work() const {
  const double fine = static_cast<double>(grid_.steps.front()) * cells_in_a_step_;
  double twins = 0;
  for (const int n : grid_.steps) twins += 2 * n;
  return 2 * fine + twins;
}

void weak_at_step::run(const scheme_entry& scheme, int from, int to, squared_errors& out) {
  extend(to);
  const auto stepper = scheme.make(grid_.dt().front());
  parallel_for(context_.threads, to - from, [&](int i) { run_scheme(*stepper, scheme.needs_areas, from + i, out); });
}

std::vector<double> weak_at_step::sizes(int blocks) {
  extend(blocks);
  std::vector<double> out(static_cast<std::size_t>(columns()));
  for (std::size_t k = 0; k < out.size(); ++k) {
    for (int b = 0; b < blocks; ++b)
      for (int lane = 0; lane < block_lanes; ++lane)
        out[k] += std::pow(
            truth_[static_cast<std::size_t>(b)].areas_known[k * block_lanes + static_cast<std::size_t>(lane)], 2);
    out[k] = std::sqrt(out[k] / (blocks * block_lanes));
  }
  return out;
}

/// Blocks that are known stay where they are, so that others may read them meanwhile.
void weak_at_step::extend(int blocks) {
  const std::lock_guard lock(extending_);
  if (blocks <= known_) return;
  parallel_for(context_.threads, blocks - known_, [&](int i) { run_truth(known_ + i); });
  known_ = blocks;
}

void weak_at_step::run_truth(int block) {
  const int first = block * block_lanes, dimension = context_.subject.model->dimension();
  driven_block truth(context_, grid_, twin_cells, {context_.generator, precise}, driven_);
  twin_chain chain(context_.subject, grid_, twin_cells, driven_);
  auto& out = truth_[static_cast<std::size_t>(block)];
  out.areas_known.reserve(static_cast<std::size_t>(columns() * block_lanes));
  out.areas_unknown.reserve(out.areas_known.capacity());
  truth.start(static_cast<std::uint64_t>(first));
  for (std::size_t look = 0, step = 0; look < looks_.size(); ++look) {
    for (; static_cast<int>(step) < looks_[look]; ++step) {
      truth.advance(static_cast<int>(step));
      chain.advance(truth);
      controls_.keep(first, static_cast<int>(look), truth.increments(0));
    }
    for (const auto& f : observables_)
      for (int lane = 0; lane < block_lanes; ++lane) {
        const auto excess = chain.excess(f.value, truth, lane);
        out.areas_known.push_back(f.value(lane_of(truth.truth(), lane, dimension)) - excess.back());
        out.areas_unknown.push_back(f.value(lane_of(truth.twin(0), lane, dimension)) - excess.front());
      }
  }
}

void weak_at_step::run_scheme(const kernel& stepper, bool with_areas, int block, squared_errors& out) const {
  const int first = block * block_lanes, dimension = context_.subject.model->dimension();
  coupled_increments noise(*context_.subject.model, grid_, twin_cells, {context_.generator, precise});
  auto states = replicated(context_.subject.scene.momentum);
  const auto& known = truth_[static_cast<std::size_t>(block)];
  auto truth = (with_areas ? known.areas_known : known.areas_unknown).begin();
  for (std::size_t look = 0, step = 0; look < looks_.size(); ++look) {
    for (; static_cast<int>(step) < looks_[look]; ++step) {
      noise.fill(context_.seed, static_cast<std::uint64_t>(first), static_cast<int>(step));
      stepper.advance(states, noise.level(0));
    }
    for (std::size_t f = 0; f < observables_.size(); ++f)
      for (int lane = 0; lane < block_lanes; ++lane)
        out.at(first + lane, static_cast<int>(look * observables_.size() + f)) =
            observables_[f].value(lane_of(states, lane, dimension)) - *truth++;
  }
}

}  // namespace polhode
