// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/orbit_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/undecided.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr double orbit_margin = 0.32;        // of the fastest rate times that and dt
constexpr double apart = 1e-6;               // of |mu|: neighbours
constexpr double first_time = 64;            // fastest time scales
constexpr std::array fineness{32, 64, 128};  // steps per fastest time scale

std::int64_t first_chunks(effort e) {
  return static_cast<std::int64_t>(first_time) * by_effort(e, fineness[0], fineness[1], fineness[2]) /
         orbit_block::chunk;
}

/// Whole blocks. A path of more vectors, of more components each, costs the square of that.
int paths_of(effort e, int vectors) {
  constexpr int usual = 4;
  const int most = std::max(usual, vectors);
  return blocks_of(by_effort(e, 256, 1024, 4096) * usual * usual / (most * most)) * block_lanes;
}

/// Every path of the equation, a stage after another.
class equation_paths {
 public:
  equation_paths(const context& c, const orbit_frame& f, int vectors, noise_log& log)
      : context_(c),
        frame_(f),
        vectors_(vectors),
        log_(log),
        flow_(neighbour_flow(c.subject.model->reference(f.dt), apart * length(c.subject.scene.momentum))) {
    for (int first = 0; first < f.paths; first += block_lanes)
      blocks_.emplace_back(f.geometry, f.start, c.seed, static_cast<std::uint64_t>(first), vectors);
  }

  observed_rates advance(std::int64_t chunks) {
    observed_rates out(frame_.paths, vectors_);
    parallel_for(context_.threads, static_cast<int>(blocks_.size()), [&](int block) {
      auto& b = blocks_[static_cast<std::size_t>(block)];
      increment_buffer noise(*context_.subject.model, orbit_block::chunk, any_needs_areas(context_.subject.schemes),
                             {context_.generator, noise_quality::fast});
      for (std::int64_t i = passed_; i < passed_ + chunks; ++i) {
        const auto view = noise.fill(context_.seed, static_cast<std::uint64_t>(block) * block_lanes,
                                     static_cast<std::uint64_t>(i * orbit_block::chunk), orbit_block::chunk, frame_.dt);
        log_.add(block, view, frame_.dt);
        b.advance(*flow_, view);
      }
      out.keep(block, b.read());
    });
    passed_ += chunks;
    context_.progress(std::min(1.0, static_cast<double>(passed_) / static_cast<double>(frame_.most_chunks)));
    return out;
  }

 private:
  const context& context_;
  const orbit_frame& frame_;
  int vectors_;
  noise_log& log_;
  std::unique_ptr<tangent_flow> flow_;
  std::vector<orbit_block> blocks_;
  std::int64_t passed_ = 0;
};

/// Empty: every mean of the later span is that of the earlier one, to the margin.
std::string difference_of(const observed_rates& earlier, const observed_rates& later, double margin) {
  const Eigen::MatrixXd change = later.rates - earlier.rates;
  for (Eigen::Index k = 0; k < change.cols(); ++k) {
    const auto found = mean_interval({change.col(k).data(), static_cast<std::size_t>(change.rows())});
    if (judge(0, found.low, found.high, margin) != report::verdict_kind::holds)
      return fmt::format("lambda_{} changes by [{:.2g}, {:.2g}] from one span to the next, where {:.2g} is allowed",
                         k + 1, found.low, found.high, margin);
  }
  return "";
}

/// Of two spans, the second twice as long.
observed_rates together(const observed_rates& one, const observed_rates& two) {
  auto out = one;
  out.rates = (one.rates + 2 * two.rates) / 3;
  out.volume = (one.volume + 2 * two.volume) / 3;
  out.divergence = (one.divergence + 2 * two.divergence) / 3;
  return out;
}

}  // namespace

orbit_frame::orbit_frame(const context& c)
    : geometry(*c.subject.model, c.subject.scene.momentum),
      start(*c.subject.model, c.subject.scene.momentum),
      dt(1 / (by_effort(c.effort, fineness[0], fineness[1], fineness[2]) * fastest_rate(c.subject))),
      margin(orbit_margin * std::pow(fastest_rate(c.subject), 2) * dt),
      paths(paths_of(c.effort, geometry.dimension())),
      most_chunks(4 * first_chunks(c.effort) << by_effort(c.effort, 2, 4, 6)) {}

bool orbit_frame::affordable(const context& c, std::span<const scheme_entry> schemes, std::string_view experiment,
                             std::string_view claim, report::results& out) const {
  const double steps = 4.0 * static_cast<double>(first_chunks(c.effort) * orbit_block::chunk) * paths;
  const double components = static_cast<double>(vectors()) * c.subject.model->dimension();
  return affords(c, schemes,
                 {experiment, claim, fmt::format("a spectrum of {} exponents", vectors()), "steps of a component",
                  steps * components, [](effort e) { return by_effort(e, 1.5e8, 1e10, 1e12); }},
                 out);
}

observed_rates::observed_rates(int paths, int vectors)
    : rates(paths, vectors), volume(Eigen::VectorXd::Zero(paths)), divergence(Eigen::VectorXd::Zero(paths)) {}

void observed_rates::keep(int block, const orbit_rates& found) {
  const auto at = static_cast<Eigen::Index>(block) * block_lanes;
  rates.middleRows(at, block_lanes) = found.rates;
  if (found.volume.size() > 0) volume.segment(at, block_lanes) = found.volume;
  if (found.divergence.size() > 0) divergence.segment(at, block_lanes) = found.divergence;
}

observed_rates observe_equation(const context& c, const orbit_frame& f, int vectors, noise_log& log) {
  equation_paths paths(c, f, vectors, log);
  std::int64_t forgetting = first_chunks(c.effort);
  paths.advance(forgetting);
  auto earlier = paths.advance(forgetting), later = paths.advance(2 * forgetting);
  auto fault = difference_of(earlier, later, f.margin);
  while (!fault.empty() && 8 * forgetting <= f.most_chunks) {
    forgetting *= 2;
    earlier = std::move(later);
    later = paths.advance(2 * forgetting);
    fault = difference_of(earlier, later, f.margin);
  }
  auto out = together(earlier, later);
  out.first_third = earlier.rates;
  out.forgetting = forgetting;
  out.observed = 3 * forgetting;
  if (!fault.empty()) out.fault = fmt::format("after {} steps {}", forgetting * orbit_block::chunk, fault);
  return out;
}

}  // namespace polhode
