// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "problem/noise_covariance.hpp"

namespace polhode {
namespace {

constexpr int relaxation_chunk = 200, blocks = 2, looks_in_half = 64;  // looks: in each half of a segment
constexpr double spread_times = 3;    // relaxation times of the first degree, 1 / sigma^2
constexpr double first_segment = 16;  // fastest time scales
constexpr double long_enough = 20;    // autocorrelation times
constexpr double unlikely = 4;        // standard errors

struct moments {
  double mean = 0, error = 0, variance = 0;
};
moments moments_of(const std::vector<double>& x) {
  moments m;
  for (const double v : x) m.mean += v / static_cast<double>(x.size());
  for (const double v : x) m.variance += (v - m.mean) * (v - m.mean) / static_cast<double>(x.size() - 1);
  m.error = std::sqrt(m.variance / static_cast<double>(x.size()));
  return m;
}

/// Of one observable over a segment, path by path; paths of both kinds in turn.
struct segment {
  std::vector<double> first, second, square;  ///< means over each half; of the square over both
  explicit segment(std::size_t paths) : first(paths), second(paths), square(paths) {}

  std::vector<double> means(std::size_t kind, std::size_t kinds) const {
    std::vector<double> out;
    for (std::size_t p = kind; p < first.size(); p += kinds) out.push_back((first[p] + second[p]) / 2);
    return out;
  }
  double variance() const {
    const double mean = moments_of(means(0, 1)).mean;
    return std::max(0.0, moments_of(square).mean - mean * mean);
  }
  /// Of the length of the segment, from the variance of its means: 2 time / length times that of the observable.
  double correlation() const {
    const double all = variance();
    return all > 0 ? moments_of(means(0, 1)).variance / (2 * all) : 0;
  }
  bool drifts() const {
    std::vector<double> change;
    for (std::size_t p = 0; p < first.size(); ++p) change.push_back(second[p] - first[p]);
    const auto m = moments_of(change);
    return std::fabs(m.mean) > unlikely * m.error;
  }
  bool remembers() const {
    const auto a = moments_of(means(0, 2)), b = moments_of(means(1, 2));
    return std::fabs(a.mean - b.mean) > unlikely * std::hypot(a.error, b.error);
  }
};

/// The paths of one block and how far they are.
struct pilot_block {
  increment_buffer noise;
  paths_so_far at;
};

class pilot {
 public:
  pilot(const context& c, const std::vector<observable>& observables, double dt, std::uint64_t first_path)
      : context_(c),
        observables_(observables),
        dt_(dt),
        first_path_(first_path),
        equation_(c.subject.model->reference(dt)) {
    for (int b = 0; b < blocks; ++b)
      blocks_.push_back(
          {increment_buffer(*c.subject.model, relaxation_chunk, false, {c.generator, noise_quality::fast}), {}});
    parallel_for(c.threads, blocks,
                 [&](int b) { blocks_[static_cast<std::size_t>(b)].at = spread_start(c, dt, path(b)); });
  }

  void advance(std::int64_t steps) {
    parallel_for(context_.threads, blocks, [&](int b) { advance(b, steps); });
  }
  /// steps: of one look.
  std::vector<segment> watch(std::int64_t steps) {
    std::vector<segment> out(observables_.size(), segment(static_cast<std::size_t>(blocks) * block_lanes));
    parallel_for(context_.threads, blocks, [&](int b) {
      for (int i = 0; i < 2 * looks_in_half; ++i) {
        advance(b, steps);
        look(b, i < looks_in_half, out);
      }
    });
    return out;
  }

 private:
  std::uint64_t path(int b) const { return first_path_ + static_cast<std::uint64_t>(b * block_lanes); }
  void advance(int b, std::int64_t steps) {
    auto& [noise, at] = blocks_[static_cast<std::size_t>(b)];
    for (std::int64_t left = steps; left > 0; left -= relaxation_chunk) {
      const int n = static_cast<int>(std::min<std::int64_t>(left, relaxation_chunk));
      equation_->advance(at.states, noise.fill(context_.seed, path(b), at.steps, n, dt_));
      at.steps += static_cast<std::uint64_t>(n);
    }
  }
  void look(int b, bool first_half, std::vector<segment>& out) const {
    const auto& states = blocks_[static_cast<std::size_t>(b)].at.states;
    for (int lane = 0; lane < block_lanes; ++lane) {
      const auto mu = lane_of(states, lane, context_.subject.model->dimension());
      const auto p = static_cast<std::size_t>(b * block_lanes + lane);
      for (std::size_t f = 0; f < out.size(); ++f) {
        const double value = observables_[f].value(mu);
        (first_half ? out[f].first : out[f].second)[p] += value / looks_in_half;
        out[f].square[p] += value * value / (2 * looks_in_half);
      }
    }
  }

  const context& context_;
  const std::vector<observable>& observables_;
  double dt_;
  std::uint64_t first_path_;
  std::unique_ptr<kernel> equation_;
  std::vector<pilot_block> blocks_;
};

}  // namespace

paths_so_far spread_start(const context& c, double dt, std::uint64_t first_path, noise_log* log, int block) {
  const auto& s = c.subject;
  const auto free = s.without_dissipation();
  const auto equation = free.model->reference(dt);
  increment_buffer noise(*s.model, relaxation_chunk, false, {c.generator, noise_quality::fast});
  const double strength = isotropic_strength(s.scene);
  paths_so_far out{replicated(s.scene.momentum)};
  const auto steps = static_cast<std::uint64_t>(std::ceil(spread_times / (strength * strength * dt)));
  while (out.steps < steps) {
    const int n = static_cast<int>(std::min<std::uint64_t>(steps - out.steps, relaxation_chunk));
    const auto view = noise.fill(c.seed, first_path, out.steps, n, dt);
    if (log != nullptr) log->add(block, view, dt);
    equation->advance(out.states, view);
    out.steps += static_cast<std::uint64_t>(n);
  }
  for (std::size_t i = 0; i < out.states.size(); i += 2) out.states[i] = s.scene.momentum[i / block_lanes];
  return out;
}

relaxation relaxation_of(const context& c, const std::vector<observable>& observables, double dt, double most_steps,
                         std::uint64_t first_path) {
  pilot paths(c, observables, dt, first_path);
  const auto first = std::max(1.0, std::ceil(first_segment / (fastest_rate(c.subject) * dt * 2 * looks_in_half)));
  auto look = static_cast<std::int64_t>(first);
  paths.advance(2 * looks_in_half * look);
  for (;; look *= 2) {
    const auto found = paths.watch(look);
    const double length = static_cast<double>(2 * looks_in_half * look), time = length * dt;
    relaxation out;
    for (const auto& f : found) {
      out.deviation.push_back(std::sqrt(f.variance()));
      out.time = std::max(out.time, f.correlation() * time);
    }
    const bool drift = std::ranges::any_of(found, &segment::drifts);
    const bool memory = std::ranges::any_of(found, &segment::remembers);
    if (!drift && !memory && time >= long_enough * out.time) return out;
    if (4 * length <= most_steps) continue;
    out.reason = fmt::format("after {:.2g} steps {}", 2 * length,
                             memory  ? "paths from the scene's momentum and paths from all over the orbit still differ"
                             : drift ? "means still drift"
                                     : "a path is not yet twenty autocorrelation times long");
    return out;
  }
}

}  // namespace polhode
