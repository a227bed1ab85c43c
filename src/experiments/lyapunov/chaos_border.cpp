#include "experiments/lyapunov/chaos_border.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numeric>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"
#include "sphere/lyapunov.hpp"

namespace polhode {
namespace {

constexpr double map_tolerance = 1e-4, border_tolerance = 1e-5, border_accuracy = 1e-4;

/// The scene's problem with noise of strength s (its own directions, sum sigma sigma^T of trace 3 s^2) and dissipation
/// theta.
sphere_problem at(sphere_problem p, double s, double theta) {
  p.covariance *= 3 * s * s / p.covariance.trace();
  p.damping = theta;
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
  const double rate = p.radius * p.spread() + p.field.norm();
  const int n = by_effort(e, 6, 9, 13);
  axes out;
  for (int i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / (n - 1);
    out.sigma.push_back(as_printed(std::sqrt(rate) * 0.4 * std::pow(4.0, share)));
    out.theta.push_back(as_printed(2 * share / p.radius));
  }
  return out;
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

}  // namespace

report::measurement exact_row(const std::string& quantity, const std::string& observable, std::optional<double> value,
                              double uncertainty, const std::string& unit, const std::string& reason) {
  report::measurement m{"lyapunov", "", quantity, observable, {}, value, {}, {}, unit, "exact", "ok", {}, false};
  if (value) {
    m.low = *value - uncertainty;
    m.high = *value + uncertainty;
  }
  if (!reason.empty()) m.status = reason;
  return m;
}

void report_chaos_border(const context& c, const sphere_problem& p, report::results& out) {
  const auto grid = axes_of(p, c.effort);
  const auto easiest = lyapunov(at(p, grid.sigma.back(), grid.theta.back() / 2), map_tolerance);
  if (!easiest.reason.empty()) {
    out.skipped.push_back({"lyapunov", "", "map and border: even under strong noise lambda_1 is " + easiest.reason});
    return;
  }
  const auto n = static_cast<int>(grid.sigma.size());
  std::vector<report::measurement> map(static_cast<std::size_t>(n * n)), curve(static_cast<std::size_t>(n));
  progress_counter done(n * n + n, c.progress);
  parallel_for(c.threads, n * n + n, [&](int i) {
    const double sigma = grid.sigma[static_cast<std::size_t>(i % n)];
    if (i < n * n) {
      const double theta = grid.theta[static_cast<std::size_t>(i / n)];
      const auto found = lyapunov(at(p, sigma, theta), map_tolerance);
      map[static_cast<std::size_t>(i)] =
          exact_row("lambda_1 map", fmt::format("sigma={:.4g} theta={:.4g}", sigma, theta), found.lambda1,
                    found.uncertainty, "per time", found.reason);
    } else {
      const auto found = border(p, sigma, grid.theta.back());
      curve[static_cast<std::size_t>(i - n * n)] = exact_row(
          "border of chaos", fmt::format("sigma={:.4g}", sigma), found ? std::optional(found->theta) : std::nullopt,
          found ? found->uncertainty : 0, std::string(dissipation_key),
          found ? "" : fmt::format("lambda_1 is not known to change its sign for theta up to {:g}", grid.theta.back()));
    }
    done.add();
  });
  out.measurements.insert(out.measurements.end(), curve.begin(), curve.end());
  out.measurements.insert(out.measurements.end(), map.begin(), map.end());
}

}  // namespace polhode
