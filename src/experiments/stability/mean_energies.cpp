// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/mean_energies.hpp"

#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/stability/stability_run.hpp"
#include "sphere/expectations/expectation.hpp"

namespace polhode {
namespace {

constexpr double negligible_range = 1e-3;  // of h, relative: then h is nearly the Casimir
constexpr int low_degree = 20, fine_paths = 4096;
// Elsewhere, where a step takes longer: so many leave some 1.3, 0.5 or 0.3 % of the range.
int paths_elsewhere(effort e) { return by_effort(e, 256, 2048, 4096); }
constexpr double exact_accuracy = 0.02;  // of what a mean energy may be off

/// By harmonics of low degree, as higher ones can cost seconds; empty where that is not enough.
std::optional<double> exact_mean_energy(const stability_case& of, double tolerance) {
  const auto& problem = *of.bound.sphere();
  const auto energy = *named_observable("energy", problem);
  const Eigen::Map<const Eigen::Vector3d> start(of.bound.scene.momentum.data());
  const auto found = expectation(problem, energy, start, of.horizon, tolerance, low_degree);
  return found.converged() ? found.value : std::nullopt;
}

/// Where h is not nearly the Casimir.
void find_exact_mean_energy(stability_case& of) {
  if (!of.bounded) {
    of.mean_energy_method = "reference";
    return;
  }
  const double range = of.greatest_energy - of.least_energy;
  if (!of.normal || range <= negligible_range * of.energy_size()) return;
  of.mean_energy = exact_mean_energy(of, exact_accuracy * mean_energy_share * range);
  of.mean_energy_method = of.mean_energy ? "exact" : "reference";
}

void sample_mean_energy(const context& c, const block_listener& hear, stability_case& of) {
  const auto found = true_paths(of, of.bounded ? fine_paths : paths_elsewhere(c.effort), c.seed, c.generator, hear);
  if (std::isfinite(found.mean_energy)) of.mean_energy = found.mean_energy;
  if (of.bounded) return;
  of.least_energy = found.least_energy;
  of.greatest_energy = found.greatest_energy;
  if (!(of.greatest_energy - of.least_energy > negligible_range * of.energy_size())) of.mean_energy.reset();
}

}  // namespace

void find_mean_energies(const context& c, std::vector<stability_case>& cases, const block_listener& hear) {
  parallel_for(c.threads, static_cast<int>(cases.size()),
               [&](int i) { find_exact_mean_energy(cases[static_cast<std::size_t>(i)]); });
  std::vector<stability_case*> sampled;
  for (auto& s : cases)
    if (s.mean_energy_method == "reference") sampled.push_back(&s);
  parallel_for(c.threads, static_cast<int>(sampled.size()), [&](int i) {
    sample_mean_energy(c, i == 0 ? hear : block_listener{}, *sampled[static_cast<std::size_t>(i)]);
  });
}

}  // namespace polhode
