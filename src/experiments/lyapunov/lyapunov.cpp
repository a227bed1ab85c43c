// SPDX-License-Identifier: Apache-2.0
// Does the flow of one common noise spread or collect, and where is the border between the two?
//
// lambda_1 of the equation is exact (sphere/lyapunov.hpp), nothing is sampled; where it changes its sign is the
// border of chaos (chaos_border.hpp). The exponents of each discretisation are found over dt without sampling
// (discretisation_exponents.hpp), and at one small dt by sampling (lyapunov_sampled.hpp). Where the system does not
// live on one sphere all of it is sampled (orbit_exponents.hpp).
#include "sphere/lyapunov.hpp"

#include <fmt/format.h>

#include <string>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/operator_work.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/lyapunov/chaos_border.hpp"
#include "experiments/lyapunov/discretisation_exponents.hpp"
#include "experiments/lyapunov/lyapunov_sampled.hpp"
#include "experiments/lyapunov/orbit_exponents.hpp"
#include "transfer/frame_sums.hpp"
#include "transfer/transfer_refine.hpp"

namespace polhode {
namespace {

constexpr int affordable_degree = most_frame_degree - 2;  // the next one shows that it is enough
constexpr double finest_tolerance = 1e-10, tolerance = 1e-7, own_tolerance = 1e-6;

void report_exponents(const lyapunov_exponents& found, recorder& record) {
  record.row(exact_row({.name = "lambda_1", .unit = "per time"}, found.lambda1, found.uncertainty, found.reason));
  record.row(exact_row({.name = "lambda_1 + lambda_2", .unit = "per time"}, found.sum, found.sum_uncertainty, ""));
  if (!found.lambda1) return;
  const double low = kaplan_yorke(*found.lambda1 - found.uncertainty, found.sum),
               high = kaplan_yorke(*found.lambda1 + found.uncertainty, found.sum);
  record.value({.name = "kaplan_yorke_dimension", .method = "exact"}, found.dimension, low, high);
}

/// As exact as is affordable: the errors of the finest schemes are small.
lyapunov_exponents exact_exponents(const sphere_problem& p) {
  auto found = lyapunov(p, finest_tolerance);
  return found.reason.empty() ? found : lyapunov(p, tolerance);
}

/// Those that have a stationary law on the sphere.
std::vector<scheme_entry> schemes_on_the_sphere(const subject& s, report::results& out) {
  std::vector<scheme_entry> kept;
  for (const auto& scheme : s.schemes) {
    if (scheme.info.casimir.exact)
      kept.push_back(scheme);
    else
      out.skipped.push_back(
          {"lyapunov", std::string(scheme.info.name),
           "leaves the sphere (experiment casimir): it has no stationary law there, hence no exponents"});
  }
  return kept;
}

/// Why the exponents of the discretisations are not asked for; empty: they are. Their laws are about as rough as the
/// exact one.
std::string too_dear(const sphere_problem& p, const lyapunov_exponents& exact) {
  if (!exact.reason.empty()) return "lambda_1 is " + exact.reason;
  const int needed = lyapunov(p, own_tolerance).degree;
  if (needed <= affordable_degree) return "";
  return fmt::format(
      "under noise this weak the law of tangent directions needs Wigner functions of degree {}, and {} are affordable",
      needed, affordable_degree);
}

/// The exponents of each scheme at the step at which they are compared.
known_growths discretisation_growths(const context& c, const std::vector<scheme_entry>& schemes,
                                     const lyapunov_exponents& exact) {
  constexpr double share = 0.25;  // of an error: it is held against a margin
  const Eigen::Vector2d value(*exact.lambda1, exact.sum);
  const transfer_target target{value, Eigen::Vector2d::Constant(fastest_rate(c.subject)), share};
  known_growths out(schemes.size());
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const auto found = refine_exponents(c.subject, schemes[k], compared_step(c.subject), target);
    if (found.error.allFinite()) out[k] = {value + found.error, found.uncertainty};
  });
  return out;
}

void report_schemes(const context& c, const sphere_problem& p, const lyapunov_exponents& exact, report::results& out) {
  const auto schemes = schemes_on_the_sphere(c.subject, out);
  if (schemes.empty()) return;
  const auto reason = too_dear(p, exact);
  if (!reason.empty()) {
    report_sampled_exponents(c, schemes, exact, out);
    leave_open(schemes, "lyapunov", exponents_order_claim, reason, out);
    return;
  }
  report_sampled_exponents(part_of(c, 0, 0.5), schemes, exact, out,
                           [&] { return discretisation_growths(c, schemes, exact); });
  report_discretisation_exponents(part_of(c, 0.5, 1), schemes, exact, out);
}

void run(const context& c, report::results& out) {
  if (!c.subject.sphere()) return report_orbit_exponents(c, out);
  const auto p = *c.subject.sphere();
  const auto exact = exact_exponents(p);
  recorder of_equation("lyapunov", "", out);
  report_exponents(exact, of_equation);
  report_schemes(part_of(c, 0, 0.5), p, exact, out);
  report_chaos_border(part_of(c, 0.5, 1), p, of_equation, out);
}

std::optional<std::string> skip_reason(const subject& s) {
  if (!s.sphere()) return no_orbit_exponents(s);
  if (s.model->noise() == noise_class::none) return "no noise: there is no random flow";
  if (!s.sphere()->varying.empty()) return "the noise depends on the state and stretches as well: no exact exponents";
  if (s.sphere()->is_spherical()) return "a spherical body turns rigidly: both exponents are 0";
  return std::nullopt;
}

expected_work work_of(const subject& s, effort e) {
  if (s.sphere()) return {by_effort(e, 5e6, 1e7, 1e8), by_sphere(s, 0.3, 0.3, 2)};
  return {by_effort(e, 1e7, 3e7, 3e8), 0};
}

}  // namespace

experiment lyapunov_experiment() {
  return {
      {"lyapunov",
       "Does one common noise spread neighbouring bodies or collect them, and where is the border of chaos?",
       {"On a sphere: lambda_1 is the mean stretching rate under the stationary law of tangent directions, solved for "
        "in Wigner "
        "functions whose degree is raised until it has converged; lambda_1 + lambda_2 is the mean divergence. Nothing "
        "of this is sampled.",
        "Dimension: Kaplan and Yorke's 1 + lambda_1/|lambda_2|; 0, a point, for lambda_1 <= 0.",
        "Border of chaos: the theta at which lambda_1 changes its sign, for noise in the scene's directions of "
        "strength sigma (sum of squares 3 sigma^2). Map: lambda_1 over both.",
        "Exponents of a scheme: found if within a thousandth of the scene's fastest rate of the exact ones, at 128 "
        "steps per fastest time scale. They are its own, not sampled (see below). Paths that have forgotten their "
        "start "
        "(eight relaxation times), 256 observed for as long again, are held against them: growth of lengths and areas "
        "under the derivative of the scheme's own step (dual numbers). Of these means the noise that is known to "
        "vanish is taken out by least squares (control variates). Where the operator cannot be had, the 95 % interval "
        "of such paths, five times as long and as many as it takes, decides.",
        "Order of the exponents: a scheme's own exponents at each dt, not sampled. One step's expectation over the "
        "noise (Gauss-Hermite) of its map of tangent directions, projected on Wigner functions; the law that this "
        "operator leaves as it is, and the mean growth under it. Intervals: the change at the last refinement, and "
        "the exact value's own; a fit uses errors of at least fifty times that. At least the weak order is claimed.",
        "Elsewhere, on a coadjoint orbit of dimension d, all d exponents are sampled: growth of an orthonormal basis "
        "of "
        "its tangent space (Benettin et al. 1980; Casimirs, whose exponents are 0, have no direction there), bodies "
        "spread over the orbit, at 32, 64, 128 steps per fastest time scale by effort. The equation's are those of the "
        "Wong-Zakai equation through the same increments, its tangents by neighbours 1e-6 apart: nothing of it is a "
        "scheme's. Time to forget the start: doubled until means over the span that follows and over the next, twice "
        "as long, agree to the margin. A scheme's exponents, by the derivative of its own step, must lie within a "
        "third of rate^2 dt of the equation's on the same paths. The sum of all is the mean divergence of the drift "
        "with "
        "respect to Liouville's volume, path by path, as the noise keeps that: held at dt and dt/2 extrapolated to 0, "
        "to a thousandth of the fastest rate. Without dissipation exponents come in pairs that cancel. The sign of "
        "lambda_1 is asked of schemes where that of the equation is known.",
        "Normals: fast ones (right to 1e-6). Areas are drawn from the weak surrogate."}},
      work_of,
      skip_reason,
      run};
}

}  // namespace polhode
