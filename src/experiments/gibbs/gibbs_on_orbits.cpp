// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/gibbs_on_orbits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/gibbs/known_means.hpp"
#include "experiments/gibbs/long_runs.hpp"
#include "experiments/gibbs/marginal_laws.hpp"
#include "experiments/gibbs/relaxation.hpp"
#include "problem/observables.hpp"

namespace polhode {
namespace {

constexpr double forgetting = 10, averaging = 20;  // autocorrelation times
constexpr int looks = 256;                         // at a path while it is averaged
constexpr double tight_share = 1.0 / 3;            // of a margin: the half-width at which sampling stops

struct design {
  double dt = 0;
  std::int64_t burn = 0, spacing = 0;  ///< in steps
  std::vector<observable> observables = {};
  std::vector<known_mean> means = {};
  double steps() const { return static_cast<double>(burn + looks * spacing); }
};

/// Of what the system knows the mean, and of what scatters at all.
design design_for(const subject& s, double dt, const std::vector<observable>& all, const relaxation& found) {
  const auto steps = [&](double times) { return static_cast<std::int64_t>(std::ceil(times * found.time / dt)); };
  design out{.dt = dt, .burn = steps(forgetting), .spacing = steps(averaging / looks)};
  for (std::size_t f = 0; f < all.size(); ++f) {
    const auto law = s.offers->gibbs_mean(all[f].name);
    const known_mean mean{law && law->value ? *law->value : NAN, found.deviation[f]};
    const double size = std::fabs(mean.exact) + mean.deviation;
    if (!std::isfinite(mean.exact) || mean.deviation <= 1e-9 * size || law->uncertainty > 0.01 * mean.margin())
      continue;
    out.observables.push_back(all[f]);
    out.means.push_back(mean);
  }
  return out;
}

/// Of one scheme.
struct sample {
  std::vector<std::vector<double>> averages;  ///< in time: [observable][path]
  marginal_samples values;
};
struct finding {
  std::vector<interval_estimate> means, distances;
};

void run_block(const context& c, const design& d, std::span<const scheme_entry> schemes,
               std::span<const std::unique_ptr<kernel>> kernels, std::span<const int> open, int block,
               std::vector<sample>& out, noise_log& log) {
  constexpr std::int64_t chunk = 200;
  const std::vector<std::size_t> indices(open.begin(), open.end());
  const bool areas = std::ranges::any_of(indices, [&](std::size_t k) { return schemes[k].needs_areas; });
  increment_buffer noise(*c.subject.model, chunk, areas, {c.generator, noise_quality::fast});
  const auto first_path = static_cast<std::uint64_t>(block * block_lanes);
  auto [start, step] = spread_start(c, d.dt, first_path, &log, block);
  std::vector<std::vector<double>> states(kernels.size(), start);
  const auto advance = [&](std::int64_t steps) {
    for (std::int64_t left = steps; left > 0; left -= chunk) {
      const int n = static_cast<int>(std::min(left, chunk));
      const auto view = noise.fill(c.seed, first_path, step, n, d.dt);
      log.add(block, view, d.dt);
      for (const auto k : indices) kernels[k]->advance(states[k], view);
      step += static_cast<std::uint64_t>(n);
    }
  };
  advance(d.burn);
  for (int i = 0; i < looks; ++i) {
    advance(d.spacing);
    for (const auto k : indices)
      for (int lane = 0; lane < block_lanes; ++lane) {
        const auto mu = lane_of(states[k], lane, c.subject.model->dimension());
        for (std::size_t f = 0; f < d.observables.size(); ++f)
          out[k].averages[f][first_path + static_cast<std::size_t>(lane)] += d.observables[f].value(mu) / looks;
        out[k].values.keep(mu, first_path + static_cast<std::size_t>(lane), i, looks);
      }
  }
}

finding find(const sample& s, int paths) {
  finding out{{}, s.values.distances(paths, averaging)};
  for (const auto& f : s.averages)
    out.means.push_back(mean_interval(std::span(f).first(static_cast<std::size_t>(paths))));
  return out;
}

bool tight(const design& d, const finding& found) {
  for (std::size_t f = 0; f < found.means.size(); ++f)
    if (!(half_width(found.means[f]) <= tight_share * d.means[f].margin())) return false;
  return tight_distances(found.distances);
}

void report_samples(const context& c, const std::vector<scheme_entry>& schemes, const design& d,
                    const sampling_plan& paths, report::results& out) {
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const auto& e : schemes) kernels.push_back(e.make(d.dt));
  const std::vector<double> room(static_cast<std::size_t>(blocks_of(paths.most) * block_lanes));
  std::vector<sample> samples(kernels.size(), {std::vector(d.observables.size(), room),
                                               marginal_samples(c.subject, static_cast<int>(room.size()))});
  noise_log log(*c.subject.model, blocks_of(paths.most));
  std::vector<finding> found(kernels.size());
  const auto sizes = sample_until_tight(
      c, paths, static_cast<int>(kernels.size()),
      [&](int block, std::span<const int> open) { run_block(c, d, schemes, kernels, open, block, samples, log); },
      [&](int scheme, int so_far) {
        const auto k = static_cast<std::size_t>(scheme);
        found[k] = find(samples[k], so_far);
        return tight(d, found[k]);
      });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    recorder record("gibbs", schemes[k].info.name, out);
    report_known_means(d.observables, d.means, d.dt, found[k].means, record);
    report_marginals(c.subject, d.dt, found[k].distances, record);
    record.remark(sizes[k].text());
  }
  log.report("gibbs", out);
}

}  // namespace

void report_sampled_means(const context& c, report::results& out) {
  if (const auto reason = no_gibbs_means(c.subject)) {
    out.skipped.push_back({"gibbs", "", "sampled law: " + *reason});
    return;
  }
  std::vector<scheme_entry> schemes;
  std::ranges::copy_if(c.subject.schemes, std::back_inserter(schemes),
                       [](const scheme_entry& e) { return e.info.casimir.exact; });
  const auto affordable = [](effort e) { return by_effort(e, 1e5, 4e5, 2e6); };
  const sampling_plan paths{128, by_effort(c.effort, 512, 2048, 8192)};
  const double dt = 0.04 / fastest_rate(c.subject);
  const auto all = observables_of(c.subject, averaged_components);
  const auto start =
      relaxation_of(c, all, dt, affordable(c.effort), static_cast<std::uint64_t>(blocks_of(paths.most) * block_lanes));
  if (!start.reason.empty())
    return leave_open(schemes, "gibbs", "mean of energy", "the start is not forgotten: " + start.reason, out);
  const auto d = design_for(c.subject, dt, all, start);
  const dear_claim law{"gibbs",        "mean of energy", "forgetting the start and averaging",
                       "steps a path", d.steps(),        affordable};
  if (affords(c, schemes, law, out)) report_samples(c, schemes, d, paths, out);
}

}  // namespace polhode
