// Does the flow of one common noise spread or collect, and where is the border between the two?
//
// lambda_1 of the equation is exact (references/lyapunov.hpp), nothing is sampled. The border of chaos theta*(sigma) is
// the root of lambda_1 in theta, found for each strength of the noise; the map is lambda_1 over both. The exponents of
// each scheme are its own over dt, without sampling (lyapunov_own.hpp), and at one small dt sampled ones
// (lyapunov_sampled.hpp).
#include "references/lyapunov.hpp"

#include <fmt/format.h>

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numeric>
#include <string>

#include "ensemble/frame_sums.hpp"
#include "ensemble/paths.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lyapunov_own.hpp"
#include "experiments/lyapunov_sampled.hpp"
#include "experiments/progress_counter.hpp"
#include "experiments/transfer.hpp"
#include "experiments/undecided.hpp"

namespace polhode {
namespace {

constexpr int affordable_degree = most_frame_degree - 2;  // the next one shows that it is enough
constexpr double finest_tolerance = 1e-10, tolerance = 1e-7, own_tolerance = 1e-6, map_tolerance = 1e-4,
                 border_tolerance = 1e-5, border_accuracy = 1e-4;

/// The scene's problem with noise of strength s (its own directions, sum sigma sigma^T of trace 3 s^2) and dissipation
/// theta.
sphere_problem at(sphere_problem p, double s, double theta) {
  p.covariance *= 3 * s * s / p.covariance.trace();
  p.theta = theta;
  return p;
}

struct axes {
  std::vector<double> sigma, theta;
};

/// To four digits, so that what is printed of a place is all of it.
double as_printed(double x) { return std::stod(fmt::format("{:.4g}", x)); }

/// Strengths and dissipations around those at which noise, dissipation and the free motion are of one size. Weaker
/// noise needs degrees beyond what a map can afford.
axes axes_of(const sphere_problem& p, effort e) {
  const auto [least, most] = std::ranges::minmax(p.inertia);
  const double rate = p.radius * (1 / least - 1 / most);
  const int n = by_effort(e, 6, 9, 13);
  axes out;
  for (int i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / (n - 1);
    out.sigma.push_back(as_printed(std::sqrt(rate) * 0.4 * std::pow(4.0, share)));
    out.theta.push_back(as_printed(2 * share / p.radius));
  }
  return out;
}

report::measurement row(const std::string& quantity, const std::string& observable, std::optional<double> value,
                        double uncertainty, const std::string& unit, const std::string& reason) {
  report::measurement m{"lyapunov", "", quantity, observable, {}, value, {}, {}, unit, "exact", "ok", {}, false};
  if (value) {
    m.low = *value - uncertainty;
    m.high = *value + uncertainty;
  }
  if (!reason.empty()) m.status = reason;
  return m;
}

struct root {
  double theta, uncertainty;
};

/// The root in that bracket; uncertain by the bracket, and by the uncertainty of lambda_1 over its slope.
std::optional<root> with_uncertainty(const sphere_problem& p, double sigma, std::pair<double, double> bracket) {
  const double theta = std::midpoint(bracket.first, bracket.second), step = 0.01 * theta;
  const auto below = lyapunov(at(p, sigma, theta - step), border_tolerance),
             above = lyapunov(at(p, sigma, theta + step), border_tolerance);
  if (!below.lambda1 || !above.lambda1 || !(*above.lambda1 < *below.lambda1)) return std::nullopt;
  const double slope = (*below.lambda1 - *above.lambda1) / (2 * step);
  const double lambda = std::max(below.uncertainty, above.uncertainty);
  return root{theta, (bracket.second - bracket.first) / 2 + lambda / slope};
}

/// theta > 0 with lambda_1 = 0 at that noise; empty if lambda_1 has one sign on the range, or is not known there.
std::optional<root> border(const sphere_problem& p, double sigma, double most_theta) {
  bool known = true;
  const auto lambda = [&](double theta) {
    const auto found = lyapunov(at(p, sigma, theta), border_tolerance);
    known = known && found.lambda1;
    return found.lambda1.value_or(1);
  };
  const double low = 0.02 * most_theta;
  if (!(lambda(low) > 0) || !(lambda(most_theta) < 0) || !known) return std::nullopt;
  std::uintmax_t steps = 30;
  const auto bracket = boost::math::tools::toms748_solve(
      lambda, low, most_theta, [](double a, double b) { return std::fabs(b - a) < border_accuracy * std::fabs(a); },
      steps);
  if (!known) return std::nullopt;
  return with_uncertainty(p, sigma, bracket);
}

void report_exponents(const lyapunov_exponents& found, report::results& out) {
  out.measurements.push_back(row("lambda_1", "", found.lambda1, found.uncertainty, "per time", found.reason));
  out.measurements.push_back(row("lambda_1 + lambda_2", "", found.sum, found.sum_uncertainty, "per time", ""));
  if (!found.lambda1) return;
  out.measurements.push_back(row("kaplan_yorke_dimension", "", found.dimension, 0, "", ""));
  out.measurements.back().low = kaplan_yorke(*found.lambda1 - found.uncertainty, found.sum);
  out.measurements.back().high = kaplan_yorke(*found.lambda1 + found.uncertainty, found.sum);
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

/// Why the schemes' own exponents are not asked for; empty: they are. Their laws are about as rough as the exact one.
std::string too_dear(const sphere_problem& p, const lyapunov_exponents& exact) {
  if (!exact.reason.empty()) return "lambda_1 is " + exact.reason;
  const int needed = lyapunov(p, own_tolerance).degree;
  if (needed <= affordable_degree) return "";
  return fmt::format(
      "under noise this weak the law of tangent directions needs Wigner functions of degree {}, and {} are affordable",
      needed, affordable_degree);
}

void report_schemes(const context& c, const sphere_problem& p, const lyapunov_exponents& exact, report::results& out) {
  const auto schemes = schemes_on_the_sphere(c.subject, out);
  if (schemes.empty()) return;
  report_sampled_exponents(part_of(c, 0, 0.5), schemes, exact, out);
  const auto reason = too_dear(p, exact);
  if (reason.empty())
    report_own_exponents(part_of(c, 0.5, 1), schemes, exact, out);
  else
    leave_open(schemes, "lyapunov", own_order_claim, reason, out);
}

void run(const context& c, report::results& out) {
  const auto p = *sphere_problem_of(c.subject);
  const auto exact = exact_exponents(p);
  report_exponents(exact, out);
  report_schemes(part_of(c, 0, 0.5), p, exact, out);
  const auto mapping = part_of(c, 0.5, 1);
  const auto grid = axes_of(p, c.effort);
  const auto easiest = lyapunov(at(p, grid.sigma.back(), grid.theta.back() / 2), map_tolerance);
  if (!easiest.reason.empty()) {
    out.skipped.push_back({"lyapunov", "", "map and border: even under strong noise lambda_1 is " + easiest.reason});
    return;
  }
  const auto n = static_cast<int>(grid.sigma.size());
  std::vector<report::measurement> map(static_cast<std::size_t>(n * n)), curve(static_cast<std::size_t>(n));
  progress_counter done(n * n + n, mapping.progress);
  parallel_for(c.threads, n * n + n, [&](int i) {
    const double sigma = grid.sigma[static_cast<std::size_t>(i % n)];
    if (i < n * n) {
      const double theta = grid.theta[static_cast<std::size_t>(i / n)];
      const auto found = lyapunov(at(p, sigma, theta), map_tolerance);
      map[static_cast<std::size_t>(i)] = row("lambda_1 map", fmt::format("sigma={:.4g} theta={:.4g}", sigma, theta),
                                             found.lambda1, found.uncertainty, "per time", found.reason);
    } else {
      const auto found = border(p, sigma, grid.theta.back());
      curve[static_cast<std::size_t>(i - n * n)] = row(
          "border of chaos", fmt::format("sigma={:.4g}", sigma), found ? std::optional(found->theta) : std::nullopt,
          found ? found->uncertainty : 0, "theta",
          found ? "" : fmt::format("lambda_1 is not known to change its sign for theta up to {:g}", grid.theta.back()));
    }
    done.add();
  });
  out.measurements.insert(out.measurements.end(), curve.begin(), curve.end());
  out.measurements.insert(out.measurements.end(), map.begin(), map.end());
}

std::optional<std::string> cannot_say(const subject& s) {
  if (!sphere_problem_of(s)) return "the exponents are computed for the rigid body alone";
  if (s.model->noise() == noise_class::none) return "no noise: there is no random flow";
  const auto& i = s.scene.inertia;
  if (i[0] == i[1] && i[1] == i[2]) return "a spherical body turns rigidly: both exponents are 0";
  return std::nullopt;
}

}  // namespace

experiment lyapunov_experiment() {
  return {
      {"lyapunov",
       "Does one common noise spread neighbouring bodies or collect them, and where is the border of chaos?",
       {"lambda_1 is the mean stretching rate under the stationary law of tangent directions, solved for in Wigner "
        "functions whose degree is raised until it has converged; lambda_1 + lambda_2 is the mean divergence. Nothing "
        "of this is sampled.",
        "Dimension: Kaplan and Yorke's 1 + lambda_1/|lambda_2|; 0, a point, for lambda_1 <= 0.",
        "Border of chaos: the theta at which lambda_1 changes its sign, for noise in the scene's directions of "
        "strength sigma (sum of squares 3 sigma^2). Map: lambda_1 over both.",
        "Exponents of a scheme: sampled growth of lengths and areas under the derivative of its own step (dual "
        "numbers), over independent paths that have forgotten their start (eight relaxation times). Of the means the "
        "noise that is known to vanish is taken out by least squares (control variates). An exponent is found if its "
        "95 % interval lies within a thousandth of the scene's fastest rate of the exact one, at 128 steps per fastest "
        "time scale.",
        "Order of the exponents: a scheme's own exponents at each dt, not sampled. One step's expectation over the "
        "noise (Gauss-Hermite) of its map of tangent directions, projected on Wigner functions; the law that this "
        "operator leaves as it is, and the mean growth under it. Intervals: the change at the last refinement, and "
        "the exact value's own; a fit uses errors of at least fifty times that. At least the weak order is claimed.",
        "Normals: fast ones (right to 1e-6). Areas are drawn from the weak surrogate."}},
      4,
      cannot_say,
      run};
}

}  // namespace polhode
