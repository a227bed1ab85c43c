// SPDX-License-Identifier: Apache-2.0
#include "experiments/attractor/attractor_orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/attractor/attractor.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/lyapunov/orbit_runs.hpp"
#include "experiments/lyapunov/orbit_verdicts.hpp"
#include "problem/observables.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr double apart = 1e-6;            // of |mu|: neighbours
constexpr double tight_neighbours = 0.4;  // of the margin: the half-width at which sampling stops
constexpr double drift_bound = 1e-12;     // of a Casimir, as in the experiment casimir after a million steps
constexpr const char* neighbours_claim = "neighbours meet or part at the rate lambda_1";
constexpr const char* orbit_claim = "bodies stay on the orbit";

/// By the rate alone; which of both it is stands in the reason.
report::verdict judge_neighbours(const interval_estimate& lambda, const Eigen::VectorXd& differences, double margin) {
  auto v = judge_all(differences, margin, [](Eigen::Index) { return std::string("their rate"); });
  v.reason = judge_sign(lambda, corrected(lambda, mean_of(differences))).reason + "; " + v.reason;
  return v;
}

void report_neighbours(const orbit_frame& f, const std::vector<scheme_entry>& schemes, const observed_rates& equation,
                       const scheme_paths& paths, report::results& out) {
  const auto lambda = mean_of(equation.rates.col(0));
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    recorder record("attractor", schemes[k].info.name, out);
    const Eigen::VectorXd differences = paths.differences(k).col(0);
    const auto row = record.value({"rate of neighbours", "", "per time", "sampled"}, at_dt(f.dt),
                                  corrected(lambda, mean_of(differences)));
    if (equation.fault.empty())
      record.verdict(neighbours_claim, judge_neighbours(lambda, differences, f.margin), {row});
    else
      record.verdict(neighbours_claim, {.reason = "the start is not forgotten: " + equation.fault}, {row});
    record.remark(paths.text(k));
  }
}

/// The largest change of a Casimir of a block of bodies, relative to its size.
double drift_of(const model& m, const std::vector<double>& start, std::span<const double> states) {
  double largest = 0;
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto before = lane_of(start, lane, m.dimension()), after = lane_of(states, lane, m.dimension());
    const auto from = m.casimirs(before), to = m.casimirs(after), sizes = m.casimir_sizes(before);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double change = std::fabs(to[i] - from[i]) / sizes[i];
      largest = change <= largest ? largest : change;  // not finite: kept
    }
  }
  return largest;
}

/// Of the bodies whose neighbours were followed.
void report_orbits_kept(const context& c, const orbit_frame& f, const std::vector<scheme_entry>& schemes,
                        const scheme_paths& paths, report::results& out) {
  const auto start = f.start.block(c.seed, 0);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const double drift = drift_of(*c.subject.model, start, paths.last_states(k));
    recorder record("attractor", schemes[k].info.name, out);
    const auto row = record.value({"largest drift", "casimir", "relative", "sampled"}, at_dt(f.dt), drift);
    if (!std::isfinite(drift)) {
      record.verdict(orbit_claim, {.expected = 0.0, .reason = "not finite: a step of the scheme fails"}, {row});
      continue;
    }
    record.verdict(
        orbit_claim,
        judge_distance({drift, drift, drift}, drift_bound,
                       fmt::format("{} bodies from all over the orbit, {} steps: a Casimir changes by {:.1e}",
                                   block_lanes, paths.steps(k), drift)),
        {row});
  }
}

void report_schemes(const context& c, const orbit_frame& f, const std::vector<scheme_entry>& schemes,
                    const observed_rates& equation, report::results& out) {
  const double distance = apart * length(c.subject.scene.momentum);
  scheme_paths paths(c, f, schemes, equation, 1,
                     [&](const scheme_entry& e) { return neighbour_flow(e.make(f.dt), distance); });
  paths.sample(tight_neighbours * f.margin);
  report_neighbours(f, schemes, equation, paths, out);
  report_orbits_kept(c, f, schemes, paths, out);
}

std::string parts_named(const subject& s, int first) {
  const auto name = [&](int k) { return component_name(s, static_cast<std::size_t>(first + k)); };
  return fmt::format("direction of ({}, {}, {}), one noise path", name(0), name(1), name(2));
}

}  // namespace

std::optional<std::string> no_orbit_attractor(const subject& s) {
  if (s.model->noise() == noise_class::none) return "no noise: the attractor is the set of equilibria";
  if (dissipation_of(s.scene) == 0) return "no dissipation: volume is kept, so what is spread stays so";
  return std::nullopt;
}

void report_orbit_attractor(const context& c, report::results& out) {
  const orbit_frame frame(c);
  std::vector<scheme_entry> schemes;
  for (const auto& scheme : c.subject.schemes)
    if (scheme.info.casimir.exact)
      schemes.push_back(scheme);
    else
      out.skipped.push_back({"attractor", std::string(scheme.info.name),
                             "leaves its orbit (experiment casimir), on which the random attractor lies"});
  if (!frame.affordable(c, schemes, "attractor", neighbours_claim, out)) return;
  noise_log log(*c.subject.model, blocks_of(frame.paths));
  const auto equation = observe_equation(part_of(c, 0, 0.4), frame, 1, log);
  recorder record("attractor", "", out);
  record.value({"lambda_1", "", "per time", "sampled"}, mean_of(equation.rates.col(0)));
  if (!schemes.empty()) report_schemes(part_of(c, 0.4, 0.8), frame, schemes, equation, out);
  const auto last = part_of(c, 0.8, 1);
  if (const auto first = kept_vector(*c.subject.model))
    report_snapshots(last,
                     {parts_named(c.subject, *first), -1 / mean_of(equation.divergence).value, 4 * frame.dt,
                      ensemble_start::orbit, *first},
                     log, out);
  else
    out.skipped.push_back({"attractor", "", "densities: the system has no vector of constant length"});
  log.report("attractor", out);
}

}  // namespace polhode
