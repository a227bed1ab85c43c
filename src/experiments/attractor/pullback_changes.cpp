// SPDX-License-Identifier: Apache-2.0
#include "experiments/attractor/pullback_changes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "ensemble/noise/paths.hpp"
#include "ensemble/noise/shared_increments.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/attractor/harmonic_moments.hpp"
#include "experiments/common/progress_counter.hpp"

namespace polhode {
namespace {

constexpr int degree = 4, spans = pullback_spans;

/// Coefficients of both sets, by look and by the spans since their start.
using snapshots = std::vector<std::array<std::array<Eigen::VectorXd, 2>, spans>>;

/// Bodies that start at one time grow old together: looked at, they are of one age after the other.
void follow(const context& c, const attractor_frame& f, const pullback_plan& plan, const kernel& k,
            const shared_steps& noise, int start, std::size_t set, snapshots& out) {
  harmonic_moments means(degree);
  const auto blocks = static_cast<std::size_t>(plan.blocks);
  std::vector<std::vector<double>> states(blocks, std::vector<double>(3 * block_lanes));
  for (std::size_t b = 0; b < blocks; ++b)
    start_uniformly(c.seed, (set * blocks + b) * block_lanes, f.problem.radius, states[b]);
  for (int age = 0; age < spans;) {
    const int next = std::max(age + 1, spans - start), look = start + next - spans;  // to the first look at once
    if (look >= plan.looks) return;
    for (auto& block : states) {
      k.advance(block, noise, (start + age) * plan.steps, (next - age) * plan.steps);
      means.add(block);
    }
    age = next;
    out[static_cast<std::size_t>(look)][static_cast<std::size_t>(age - 1)][set] = means.take();
  }
}

snapshots pulled_back(const context& c, const attractor_frame& f, const pullback_plan& plan, const kernel& k,
                      const shared_steps& noise) {
  snapshots out(static_cast<std::size_t>(plan.looks));
  for (int start = 0; start < spans + plan.looks - 1; ++start)
    for (std::size_t set = 0; set < 2; ++set) follow(c, f, plan, k, noise, start, set, out);
  return out;
}

/// Of one path of one scheme: squares of the change from T to the next T, mean over the looks.
void add_changes(const snapshots& at, int path, squared_errors& out) {
  for (const auto& look : at)
    for (int i = 0; i + 1 < spans; ++i) {
      const auto &here = look[static_cast<std::size_t>(i)], &next = look[static_cast<std::size_t>(i + 1)];
      out.at(path, i) += (here[0] - next[0]).dot(here[1] - next[1]) / static_cast<double>(at.size());
    }
}

}  // namespace

std::vector<squared_errors> pullback_changes(const context& c, const attractor_frame& f, const pullback_plan& plan,
                                             noise_log& log, std::size_t part) {
  const squared_errors nothing{plan.paths, spans - 1,
                               std::vector<double>(static_cast<std::size_t>(plan.paths * (spans - 1)))};
  std::vector<squared_errors> out(f.schemes.size(), nothing);
  std::vector<std::unique_ptr<kernel>> steppers;
  for (const auto& scheme : f.schemes) steppers.push_back(scheme.make(f.dt));
  progress_counter done(plan.paths, c.progress);
  for (int first = 0; first < plan.paths; first += block_lanes) {
    const auto drawn =
        shared_increments::of_block(*c.subject.model, c.seed, plan.all_steps(), f.dt, any_needs_areas(f.schemes),
                                    fast_noise(c), static_cast<std::uint64_t>(first));
    const int paths = std::min(block_lanes, plan.paths - first);
    const auto view = [&](int i) {
      return drawn[static_cast<std::size_t>(i)].view(0, static_cast<int>(plan.all_steps()));
    };
    for (int i = 0; i < paths; ++i) log.add_path(first + i, view(i), f.dt, part);
    parallel_for(c.threads, paths, [&](int i) {
      for (std::size_t s = 0; s < steppers.size(); ++s)
        add_changes(pulled_back(c, f, plan, *steppers[s], steppers[s]->share(view(i))), first + i, out[s]);
      done.add();
    });
  }
  return out;
}

}  // namespace polhode
