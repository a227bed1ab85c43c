// SPDX-License-Identifier: Apache-2.0
#include "experiments/casimir/casimir_drift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

/// One scheme of those that drift, at every level.
struct drift_sample {
  const scheme_entry* scheme;
  std::vector<std::unique_ptr<kernel>> kernels;
  squared_errors squares;
  std::optional<order_fit> fit;
};

/// Squared drifts of one block of paths of the open schemes.
void run_block(const context& c, const level_grid& grid, std::span<const int> open, int block,
               std::vector<drift_sample>& samples, noise_log& log) {
  const auto& m = *c.subject.model;
  const bool areas =
      std::ranges::any_of(open, [&](int k) { return samples[static_cast<std::size_t>(k)].scheme->needs_areas; });
  increment_buffer noise(m, grid.steps.back(), areas, {c.generator, noise_quality::precise});
  const int first_path = block * block_lanes;
  for (std::size_t l = 0; l < grid.steps.size(); ++l) {
    const int n = grid.steps[l];
    const double dt = grid.horizon / n;
    const auto view =
        !m.layout().silent() ? noise.fill(c.seed, static_cast<std::uint64_t>(first_path), 0, n, dt) : silence(n);
    if (l + 1 == grid.steps.size() && !view.silent()) log.add(block, view, dt, 1);  // the others have the same normals
    for (const int k : open) {
      auto& sample = samples[static_cast<std::size_t>(k)];
      auto states = replicated(c.subject.scene.momentum);
      sample.kernels[l]->advance(states, view);
      const auto d = casimir_drifts(m, states, c.subject.scene.momentum);
      for (int lane = 0; lane < block_lanes; ++lane)
        sample.squares.at(first_path + lane, static_cast<int>(l)) = std::pow(d[static_cast<std::size_t>(lane)], 2);
    }
  }
}

void report_drift(const drift_sample& sample, std::span<const double> dt, bool noisy, recorder& record) {
  curve drift{{"drift", "casimir", "relative", noisy ? "sampled" : "deterministic"}};
  for (int l = 0; l < sample.squares.levels; ++l) {
    const auto m = level_mean(sample.squares, l);
    drift.add(dt[static_cast<std::size_t>(l)], std::sqrt(m.mean), std::sqrt(std::max(0.0, m.mean - 1.96 * m.error)),
              std::sqrt(m.mean + 1.96 * m.error));
  }
  const auto written = record.series(drift, sample.fit);
  const auto& claimed = sample.scheme->info.casimir;
  const double expected = noisy ? claimed.noisy_order : claimed.deterministic_order;
  record.verdict("order of the Casimir drift", judge_order(expected, sample.fit, true), {written});
}

}  // namespace

std::vector<double> casimir_drifts(const model& m, std::span<const double> states, std::span<const double> start) {
  const auto reference = m.casimirs(start), sizes = m.casimir_sizes(start);
  std::vector<double> out;
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto now = m.casimirs(lane_of(states, lane, m.dimension()));
    double worst = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double change = std::fabs(now[i] - reference[i]) / std::max(sizes[i], 1e-300);
      worst = std::isfinite(change) ? std::max(worst, change) : std::numeric_limits<double>::infinity();
    }
    out.push_back(worst);
  }
  return out;
}

int most_drift_paths(const context& c) { return by_effort(c.effort, 640, 2048, 8192); }

void report_casimir_drift(const context& c, noise_log& log, report::results& out) {
  constexpr double floor = 1e-13;
  const bool noisy = c.subject.model->noise() != noise_class::none;
  const auto grid = asymptotic_levels(c.subject, 256);
  const auto dt = grid.dt();
  const sampling_plan plan{noisy ? 320 : 1, noisy ? most_drift_paths(c) : 1};
  const int paths = blocks_of(plan.most) * block_lanes, levels = static_cast<int>(dt.size());
  std::vector<drift_sample> samples;
  for (const auto& scheme : c.subject.schemes) {
    if (scheme.info.casimir.exact) continue;
    samples.push_back(
        {&scheme, {}, {paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))}, {}});
    for (const double h : dt) samples.back().kernels.push_back(scheme.make(h));
  }
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(samples.size()),
      [&](int block, std::span<const int> open) { run_block(c, grid, open, block, samples, log); },
      [&](int scheme, int so_far) {
        auto& [_, kernels, squares, fit] = samples[static_cast<std::size_t>(scheme)];
        squares.paths = so_far;
        std::vector<double> rms;
        for (int l = 0; l < levels; ++l) rms.push_back(std::sqrt(level_mean(squares, l).mean));
        fit = noisy ? fit_order(dt, squares, floor, c.seed) : fit_order(dt, rms, floor);
        return !fit || half_width(*fit) <= tight_order;  // without a fit more paths would not help
      });
  for (std::size_t k = 0; k < samples.size(); ++k) {
    recorder record("casimir", samples[k].scheme->info.name, out);
    report_drift(samples[k], dt, noisy, record);
    if (noisy) record.remark(sizes[k].text());
  }
}

}  // namespace polhode
