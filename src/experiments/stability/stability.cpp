// SPDX-License-Identifier: Apache-2.0
// How large may a step be before a scheme breaks, and by what does it break first?
//
// The stability limit is found by bisection (stability_limit.hpp), for each scheme and each case (stability_case.hpp)
// by itself; a run is many paths over the horizon, watched for what is called broken (stability_run.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/dear_experiments.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/stability/mean_square_report.hpp"
#include "experiments/stability/stability_case.hpp"
#include "experiments/stability/stability_escape.hpp"
#include "experiments/stability/stability_long.hpp"
#include "experiments/stability/stability_noise.hpp"
#include "experiments/stability/stability_report.hpp"
#include "experiments/stability/stability_run.hpp"
#include "experiments/stability/stability_search.hpp"
#include "sphere/expectations/expectation.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

// The true mean energy at the horizon of every case, against which runs are held.

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

/// Exact where harmonics of low degree are enough, else by the Wong-Zakai equation; in parallel. `hear`: of the first
/// that is sampled.
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

/// One scheme a piece of work.
void report_long_runs(const context& c, const std::vector<stability_case>& cases, const stability_findings& all,
                      heard_noise& noise, report::results& out) {
  const auto& schemes = cases[0].bound.schemes;
  std::vector<report::results> parts(schemes.size());
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int task) {
    const auto k = static_cast<std::size_t>(task);
    recorder record("stability", schemes[k].info.name, parts[k]);
    report_rare_breaks(c, cases[0], schemes[k], all.found[k * cases.size()].limit, record,
                       noise.listener(heard_noise::rare_breaks, schemes[k]));
    if (!cases[0].bounded) return;  // elsewhere the long runs of the experiment casimir
    report_long_drift(c, schemes[k], record, noise.listener(heard_noise::long_drift, schemes[k]));
  });
  for (const auto& part : parts) {
    out.measurements.insert(out.measurements.end(), part.measurements.begin(), part.measurements.end());
    out.fits.insert(out.fits.end(), part.fits.begin(), part.fits.end());
  }
}

void run_stability(const context& c, bool dear, report::results& out) {
  heard_noise noise(c.subject);
  auto cases = stability_cases(c);
  if (dear) cases.erase(cases.begin() + 1, cases.end());
  find_mean_energies(c, cases, noise.listener(heard_noise::reference));
  const auto& schemes = c.subject.schemes;
  const std::size_t n = cases.size();
  const auto all = search_all(c, cases, noise);
  recorder of_all("stability", "", out);
  report_cases(cases, of_all);
  const bool on_sphere = c.subject.sphere().has_value();
  if (on_sphere) report_true_growth(c.subject, of_all);
  if (c.subject.model->noise() == noise_class::none)
    out.savings.push_back({"stability", "", "the axis of sigma, and more than one block of paths", "no noise", {}});
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    const auto of_scheme = std::span(all.found).subspan(s * n, n);
    recorder record("stability", schemes[s].info.name, out);
    report_limits(cases, of_scheme, record);
    for (std::size_t i = 0; i < n; ++i)
      for (const auto& cell : all.map[s * n + i]) record.row(cell);
    judge_orbit(schemes[s], cases, of_scheme, record);
    report_scale(c, schemes[s], record);
    if (!on_sphere) continue;
    report_mean_square(c, record);
    report_escape(cases[0], schemes[s], record);
  }
  if (c.effort == effort::thorough && !dear) report_long_runs(c, cases, all, noise, out);
  noise.report(out);
}

std::optional<std::string> skip_reason(const subject& s) {
  if (const double rate = fastest_rate(s); !std::isfinite(rate) || !(rate > 0))
    return "the rates of the scene are not numbers that double precision holds";
  return std::nullopt;
}

std::vector<std::string> notes() {
  return {
      fmt::format(
          "A path is broken where its numbers are not finite (of an implicit scheme: the equation of a step is "
          "not solved), |Pi| is off by {:g} %, or h lies outside what the sphere allows by {:g} % of the "
          "greatest h, looked at every sixteenth step and more often where there are few. A run is broken where "
          "more than {:g} % of its paths are, or the mean of h at the end is off by {:g} % of the range of h. "
          "What broke the most paths is said to come first.",
          100 * casimir_share, 100 * energy_share, 100 * broken_share, 100 * mean_energy_share),
      fmt::format(
          "Elsewhere than on a sphere: a path is broken where one of its Casimirs is off by as much; what h may be is "
          "not known, and its range is that over which the true paths are seen. Strengths of noise and dissipation "
          "are moved alone. A quarter of the paths; the map with {} paths from dt = 1/(16 rate) on. That a scheme "
          "keeps "
          "its orbit is held against the runs up to half the largest stable dt (where there are none, that dt): "
          "nearer, "
          "single steps are so long that neither a projection nor a series has an answer.",
          map_paths_elsewhere),
      fmt::format(
          "Largest stable dt: from dt = 1/({1:g} rate) by octaves, then by halves of log dt to 5 %, up to dt = "
          "{0:g}/rate; rate: bounds of the free motion, the dissipation and the noise, added; of a body c/I_min + "
          "theta c^2 (1/I_min - 1/I_max) + sum |sigma_i|^2. The interval reaches to the shortest dt that broke. "
          "Horizon: the scene's, but at least 64 of 1/rate and at most 128, 256 or 1024 by effort. Runs of different "
          "dt have different noise; 512, 2048 or 8192 paths by effort, up to four times as many where the mean is "
          "within two standard errors of its margin. With so many a mean is uncertain by about 0.5, 0.25 or 0.13 % "
          "of the range: the border by mean energy is no sharper than that.",
          longest_stable_step, 1 / first_stable_step),
      "True mean of h: the Kolmogorov operator, or where low degrees do not suffice and elsewhere than on a sphere the "
      "driven ordinary differential equation at 16 steps to 1/rate. Left out where the range of h is below 0.1 % of h.",
      "One parameter is moved at a time; inertia ratio keeps the smallest inertia. Separatrix: start near an unstable "
      "equilibrium, of a body on the middle axis. Stiff: dissipation 10^4 times as fast as the rest. Denormal: numbers "
      "below 1e-308 are taken as zero by design, so |Pi| itself is lost there, and no claim is made.",
      fmt::format(
          "Map: the share of {} paths that stay whole, over dt and theta; marked where that is all but their mean "
          "energy is off.",
          map_paths),
      "Scale: Pi -> s Pi, theta -> theta/s, sigma -> sqrt(s) sigma, t -> t/s maps solutions onto solutions; with s a "
      "power of 4 a scheme should do so bit for bit.",
      "Mean squares (on a sphere): beside each axis, with what of the noise acts along it, the equation is linear. "
      "Their rate of "
      "growth, exact, against that of the scheme: the spectral radius of E[J x J], J the Jacobian of a step at the "
      "axis "
      "by dual numbers. Its error falls at the weak order for one noise vector; a steeper slope holds.",
      "Schemes that leave the sphere: the drift is cubic and the noise normal, so that at every dt some paths run off "
      "and moments of all paths do not exist. Not sampled, from dt = 1/rate on down: the radius from which a "
      "step without noise runs off (a millionfold within 32 steps, to 1 %), a bound on the share of paths that leave "
      "the shell of experiment weak within the horizon, and the first dt at which that is below a millionth.",
      "At effort thorough: the share of a million paths that breaks at half the largest stable dt (exact binomial "
      "interval), and on a sphere the drift of |Pi| over 10^9 steps (implicit: 10^8) of each of 64 paths.",
      "Noise: moments and correlations of what was drawn, against their law: of one scheme (runs of as many steps have "
      "the same normals) the border on the scene itself, the first row of the map, the rare breaks and the first "
      "million steps of the long drift; and of the first mean energy that is sampled.",
      "Normals: fast ones (right to 1e-6). Areas are drawn from the weak surrogate (independent normals of variance "
      "dt^2/4)."};
}

expected_work work_of(const subject& s, effort e) {
  if (s.model->noise() == noise_class::none) return {by_effort(e, 1e7, 1e8, 1e9), 0};  // one block is enough
  if (s.sphere()) return {by_effort(e, 8e7, 1e9, 1e10), 0};
  return {by_effort(e, 6e6, 5e7, 2e9), 0};
}

}  // namespace

experiment stability_experiment() {
  return {{"stability", "How large may a step be before the scheme breaks, and by what does it break first?", notes()},
          work_of,
          skip_reason,
          [](const context& c, report::results& out) { run_stability(c, false, out); }};
}

experiment dear_stability_experiment() {
  auto e = stability_experiment();
  e.work = [](const subject& s, effort level) {
    constexpr double of_the_scene_alone = 0.1;
    return expected_work{of_the_scene_alone * work_of(s, level).path_steps};
  };
  e.run = [](const context& c, report::results& out) { run_stability(c, true, out); };
  return e;
}

}  // namespace polhode
