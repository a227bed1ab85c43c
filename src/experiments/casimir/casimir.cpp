// SPDX-License-Identifier: Apache-2.0
// Does a scheme stay on its coadjoint orbit?
//
// Schemes that claim to keep the Casimirs run for millions of steps: only rounding may show, and its growth law is
// reported. For the others the drift over a fixed time is measured against dt, and its order is held against the claim.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <polhode/noise/normal.hpp>

#include "ensemble/noise/paths.hpp"
#include "experiments/casimir/casimir_drift.hpp"
#include "experiments/casimir/casimir_long_run.hpp"
#include "experiments/casimir/drift_growth.hpp"
#include "experiments/common/dear_experiments.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/rounding_floor.hpp"
#include "experiments/common/sequential.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

// Is a step without noise and dissipation a Poisson map?
//
// B(mu) is the Lie-Poisson bracket as a matrix, B(mu) xi = ad*_xi mu. A map f with Jacobian J is a Poisson map if
//
//   J B(mu) J^T = B(f(mu))
//
// for every mu, as the flow of any Hamiltonian is, and so any composition of such flows: Hairer, Lubich, Wanner,
// Geometric Numerical Integration (2006), VII.4. That is more than staying on the orbit: it is what makes the energy of
// a free body oscillate instead of drift. A scheme of deterministic order p whose step is none has a defect of dt^(p+1)
// at least, as its Jacobian differs by so little from that of the flow.

constexpr int levels = 10;                // dt times the fastest rate from 1/2, halved
constexpr double bound = 1e-12;           // relative; a step's rounding leaves some 1e-15
constexpr double fit_floor = 1e-13;       // of the order of the defect
constexpr int halvings_to_first = 1;      // of 1/rate
constexpr std::uint64_t same_states = 1;  // whatever the seed of the run: nothing is sampled here

std::vector<double> states_about(const subject& s) {
  const auto n = s.scene.momentum.size();
  const double size = length(s.scene.momentum) / std::sqrt(static_cast<double>(n));
  std::vector<double> out(n * block_lanes);
  for (std::size_t lane = 0; lane < block_lanes; ++lane)
    for (std::size_t k = 0; k < n; ++k) {
      const auto z = normals<2>({same_states, noise_kind::initial_state, lane, k / 2});
      out[k * block_lanes + lane] = size * z[static_cast<int>(k % 2)];
    }
  return out;
}

/// The end points and the Jacobians of one step, [column][component][lane].
struct stepped {
  std::vector<double> end, jacobian;
};

stepped step_of(const tangent_kernel& kernel, const std::vector<double>& start, std::size_t n) {
  stepped out{start, std::vector<double>(n * start.size())};
  for (std::size_t column = 0; column < n; column += tangent_vectors) {
    std::vector<double> tangents(tangent_vectors * start.size(), 0.0);
    for (std::size_t t = 0; t < tangent_vectors && column + t < n; ++t)
      std::fill_n(tangents.begin() + static_cast<std::ptrdiff_t>(t * start.size() + (column + t) * block_lanes),
                  block_lanes, 1.0);
    out.end = start;
    kernel.advance(out.end, tangents, silence(1));
    const auto wanted = std::min<std::size_t>(tangent_vectors, n - column) * start.size();
    std::copy_n(tangents.begin(), wanted, out.jacobian.begin() + static_cast<std::ptrdiff_t>(column * start.size()));
  }
  return out;
}

Eigen::MatrixXd bracket_at(const model& m, const std::vector<double>& mu) {
  const auto n = static_cast<Eigen::Index>(mu.size());
  Eigen::MatrixXd out(n, n);
  std::vector<double> unit(mu.size(), 0.0), column(mu.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    unit[static_cast<std::size_t>(k)] = 1;
    m.coadjoint(unit, mu, column);
    unit[static_cast<std::size_t>(k)] = 0;
    out.col(k) = Eigen::Map<const Eigen::VectorXd>(column.data(), n);
  }
  return out;
}

report::verdict judge_kept(std::span<const double> defects) {
  const bool finite = std::ranges::all_of(defects, [](double d) { return std::isfinite(d); });
  const double worst = finite ? std::ranges::max(defects) : std::numeric_limits<double>::quiet_NaN();
  return judge_distance({worst, worst, worst}, bound,
                        finite ? fmt::format("|J B J^T - B| / |B| is at most {:.1e} over {} step sizes and {} states, "
                                             "bound {:g}",
                                             worst, defects.size(), block_lanes, bound)
                               : "a step is not finite: its equation was not solved");
}

/// Of a scheme that does not claim it.
report::verdict judge_defects(std::span<const double> defects, const std::optional<order_fit>& fit, double expected) {
  auto kept = judge_kept(defects);
  if (kept.kind != report::verdict_kind::holds) return judge_order(expected, fit, true);
  kept.reason = "a Poisson map on this scene, though none in general: " + kept.reason;
  return kept;
}

/// Largest |J B J^T - B(f)| / |B(f)| (Frobenius) of one step of dt over a block of states of Gaussian direction about
/// as long as the momentum, the same always; s: without noise and dissipation. NaN where a step is not finite.
double poisson_defect(const subject& s, const scheme_entry& scheme, double dt) {
  const auto n = s.scene.momentum.size();
  const auto start = states_about(s);
  const auto after = step_of(*scheme.tangent(dt), start, n);
  double worst = 0;
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto dimension = static_cast<int>(n);
    const auto before = bracket_at(*s.model, lane_of(start, lane, dimension));
    const auto at_end = bracket_at(*s.model, lane_of(after.end, lane, dimension));
    Eigen::MatrixXd jacobian(before.rows(), before.cols());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            after.jacobian[(j * n + i) * block_lanes + static_cast<std::size_t>(lane)];
    const double defect = (jacobian * before * jacobian.transpose() - at_end).norm() / at_end.norm();
    if (std::isnan(defect) || defect > worst) worst = defect;
  }
  return worst;
}

/// Of the recorder's scheme. Where it claims it: the defect is rounding at every dt. Else the order of the defect.
void report_poisson_map(const context& c, recorder& record) {
  const auto s = c.subject.without_noise().without_dissipation();
  const auto& scheme = *std::ranges::find(s.schemes, record.scheme(), [](const auto& e) { return e.info.name; });
  curve defect{{"Poisson defect", "bracket", "relative", "exact"}};
  std::vector<double> dt, defects;
  for (int l = 0; l < levels; ++l) {
    dt.push_back(std::exp2(-l - halvings_to_first) / fastest_rate(s));
    defects.push_back(poisson_defect(s, scheme, dt.back()));
    defect.add(dt.back(), defects.back());
  }
  const auto fit = fit_order(dt, defects, fit_floor);
  const auto written = record.series(defect, fit);
  if (scheme.info.poisson)
    record.verdict("Poisson map without noise and dissipation", judge_kept(defects), {written});
  else
    record.verdict("order of the Poisson defect", judge_defects(defects, fit, scheme.info.deterministic_order + 1),
                   {written});
}

void run(const context& c, bool dear, report::results& out) {
  noise_log log(*c.subject.model, blocks_of(most_drift_paths(c)), {{"", 0}, {"precise", 0}});
  report_long_runs(c, dear, log, out);
  report_casimir_drift(c, log, out);
  log.report("casimir", out);
  for (const auto& scheme : c.subject.schemes) {
    recorder record("casimir", scheme.info.name, out);
    report_floor("state at the rounding floor", rounding_floor_of(c, c.subject, scheme).state, record);
    report_poisson_map(c, record);
  }
}

expected_work work_of(const subject& s, effort e, bool dear) { return {steps_of_long_run(s, e, dear), 0.01}; }

}  // namespace

experiment casimir_experiment() {
  return {
      {"casimir",
       "Does the scheme stay on the coadjoint orbit on which it started?",
       {fmt::format(
            "Schemes that claim it run for a million steps and more on {} paths at the scene's finest dt (at "
            "effort quick a fifth of it and less where a state has more than three components or lies in a field, or "
            "noise depends on it, taken on to a million as the drift grows); a relative drift of {:g} per million "
            "steps is the "
            "bound. Plotted: root mean "
            "square over the paths; "
            "bars reach to the largest.",
            block_lanes, rounding_bound),
        "For the others: root-mean-square relative drift over the horizon against dt. Where a long run needs Levy "
        "areas "
        "they are drawn from a weak surrogate (independent normals of variance dt^2/4).",
        "Rounding floor: high differences of the state over steps that differ a little are rounding alone.",
        "Poisson map: whether the Jacobian J of a step without noise and dissipation, by dual numbers, keeps the "
        "bracket, J B(mu) J^T = B(step(mu)). Of schemes that do not claim it, the order of what is missing, which is "
        "their deterministic order and one more, or better.",
        "Normals: fast ones (right to 1e-6) in the long runs, precise ones for the drift."}},
      [](const subject& s, effort e) { return work_of(s, e, false); },
      [](const subject&) -> std::optional<std::string> { return std::nullopt; },
      [](const context& c, report::results& out) { run(c, false, out); }};
}

experiment dear_casimir_experiment() {
  auto e = casimir_experiment();
  e.work = [](const subject& s, effort level) { return work_of(s, level, true); };
  e.run = [](const context& c, report::results& out) { run(c, true, out); };
  return e;
}

}  // namespace polhode
