// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/gibbs_sampled.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "algebra/decompositions.hpp"
#include "ensemble/noise/paths.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/gibbs/gibbs_moments.hpp"
#include "problem/vectors.hpp"
#include "sphere/equilibria.hpp"

namespace polhode {
namespace {

constexpr double most_path_steps = 10'000;  // of a path, before sampling is too dear to be offered

/// The least eigenvalue of sum sigma_i sigma_i^T: sigma^2 where the noise is isotropic, else its weakest direction.
double noise_strength(const subject& s) {
  return std::max(0.0, symmetric_eigenpairs_of(s.sphere()->covariance).values[0]);
}

/// Time to forget the start: relaxation on the sphere (rate sigma^2), slowed by the barrier between the wells of h.
/// Damping and rotation only help; the factor five is a choice.
double burn_in(const subject& s) {
  const double sigma2 = noise_strength(s);
  return 5 / sigma2 * std::exp(2 * dissipation_of(s.scene) / sigma2 * barrier_between_wells(*s.sphere()));
}

double step_size(const subject& s) { return 0.04 / fastest_rate(s); }

struct sphere_design {
  double dt, burn, spacing;
};

sphere_design plan(const context& c) {
  const auto& s = c.subject;
  return {step_size(s), burn_in(s), 1 / noise_strength(s)};
}

/// Runs one block of paths of the open schemes through the same noise.
void run_spheres(const context& c, const sphere_design& d, std::span<const scheme_entry> schemes,
                 std::span<const std::unique_ptr<kernel>> kernels, std::span<const int> open, int block,
                 std::vector<path_means>& out, noise_log& log) {
  constexpr int chunk = 200;
  const auto& s = c.subject;
  const std::vector<std::size_t> indices(open.begin(), open.end());
  const bool areas = std::ranges::any_of(indices, [&](std::size_t k) { return schemes[k].needs_areas; });
  increment_buffer noise(*s.model, chunk, areas, {c.generator, noise_quality::fast});
  const auto first_path = static_cast<std::uint64_t>(block * block_lanes);
  std::vector<std::vector<double>> states(kernels.size(), uniform_states(c.seed, first_path, length(s.scene.momentum)));
  std::uint64_t step = 0;
  const auto advance = [&](double time) {
    for (int left = std::max(1, static_cast<int>(time / d.dt)); left > 0;) {
      const int n = std::min(left, chunk);
      const auto view = noise.fill(c.seed, first_path, step, n, d.dt);
      log.add(block, view, d.dt);
      for (const auto k : indices) kernels[k]->advance(states[k], view);
      step += static_cast<std::uint64_t>(n);
      left -= n;
    }
  };
  advance(d.burn);
  for (int i = 0; i < observations; ++i) {
    advance(d.spacing);
    for (const auto k : indices) observe(*s.model, states[k], block, out[k]);
  }
}

void report_spheres(const context& c, const std::vector<scheme_entry>& schemes, report::results& out) {
  const auto& s = c.subject;
  const double radius = length(s.scene.momentum);
  const gibbs_law law = s.offers->gibbs ? s.offers->gibbs() : gibbs_law::by_quadrature(*s.sphere());
  const auto d = plan(c);
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const auto& scheme : schemes) kernels.push_back(scheme.make(d.dt));
  const sampling_plan paths{2048, by_effort(c.effort, 4096, 16'384, 32'768)};
  std::vector<path_means> samples(kernels.size(),
                                  path_means(static_cast<std::size_t>(blocks_of(paths.most) * block_lanes)));
  const auto moments = moments_of(law, radius);
  noise_log log(*s.model, blocks_of(paths.most));
  std::vector<gibbs_finding> found(kernels.size());
  const auto sizes = sample_until_tight(
      c, paths, static_cast<int>(kernels.size()),
      [&](int block, std::span<const int> open) { run_spheres(c, d, schemes, kernels, open, block, samples, log); },
      [&](int scheme, int so_far) {
        const auto k = static_cast<std::size_t>(scheme);
        found[k] = find(law, moments, samples[k], so_far);
        return tight(moments, found[k]);
      });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    recorder record("gibbs", schemes[k].info.name, out);
    report_finding(moments, d.dt, found[k], record);
    record.remark(sizes[k].text());
  }
  log.report("gibbs", out);
}

/// Why no law is claimed that could be sampled; empty: one is.
std::optional<std::string> no_law(const subject& s) {
  if (s.model->noise() != noise_class::isotropic && dissipation_of(s.scene) > 0)
    return "the noise is not isotropic: no Gibbs law is claimed for it";
  if (noise_strength(s) <= 1e-12 * fastest_rate(s)) return "the noise does not reach every direction by itself";
  return std::nullopt;
}

}  // namespace

void report_sampled_law(const context& c, report::results& out) {
  if (const auto reason = no_law(c.subject)) {
    out.skipped.push_back({"gibbs", "", "sampled law: " + *reason});
    return;
  }
  std::vector<scheme_entry> schemes;
  std::ranges::copy_if(c.subject.schemes, std::back_inserter(schemes),
                       [](const scheme_entry& e) { return e.info.casimir.exact; });
  const dear_claim law{"gibbs",
                       "mean of energy",
                       "the wells of h are deep: forgetting the start",
                       "steps a path",
                       burn_in(c.subject) / step_size(c.subject),
                       [](effort) { return most_path_steps; }};
  if (affords(c, schemes, law, out)) report_spheres(c, schemes, out);
}

}  // namespace polhode
