// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/chaos_border.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"
#include "sphere/lyapunov.hpp"

namespace polhode {
namespace {

constexpr const char* strength = "sigma";  // of isotropic noise, or of noise in the scene's directions
constexpr double map_tolerance = 1e-4, border_tolerance = 1e-5, border_accuracy = 1e-4;

/// The scene's problem with noise of strength s (its own directions, sum sigma sigma^T of trace 3 s^2) and so much
/// dissipation.
sphere_problem at(sphere_problem p, double s, double dissipation) {
  p.covariance *= 3 * s * s / p.covariance.trace();
  p.damping = dissipation;
  return p;
}

struct axes {
  std::vector<double> sigma, dissipation;
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
    out.dissipation.push_back(as_printed(2 * share / p.radius));
  }
  return out;
}

struct root {
  double dissipation, uncertainty;
};

/// The root in that bracket; uncertain by the bracket, and by the uncertainty of lambda_1 over its slope.
std::optional<root> with_uncertainty(const sphere_problem& p, double sigma, std::pair<double, double> bracket) {
  const double middle = std::midpoint(bracket.first, bracket.second), step = 0.01 * middle;
  const auto below = lyapunov(at(p, sigma, middle - step), border_tolerance),
             above = lyapunov(at(p, sigma, middle + step), border_tolerance);
  if (!below.lambda1 || !above.lambda1 || !(*above.lambda1 < *below.lambda1)) return std::nullopt;
  const double slope = (*below.lambda1 - *above.lambda1) / (2 * step);
  const double lambda = std::max(below.uncertainty, above.uncertainty);
  return root{middle, (bracket.second - bracket.first) / 2 + lambda / slope};
}

/// The dissipation with lambda_1 = 0 at that noise; empty if lambda_1 has one sign on the range, or is not known there.
std::optional<root> border(const sphere_problem& p, double sigma, double most) {
  bool known = true;
  const auto lambda = [&](double dissipation) {
    const auto found = lyapunov(at(p, sigma, dissipation), border_tolerance);
    known = known && found.lambda1;
    return found.lambda1.value_or(1);
  };
  const double low = 0.02 * most;
  if (!(lambda(low) > 0) || !(lambda(most) < 0) || !known) return std::nullopt;
  std::uintmax_t steps = 30;
  const auto bracket = boost::math::tools::toms748_solve(
      lambda, low, most, [](double a, double b) { return std::fabs(b - a) < border_accuracy * std::fabs(a); }, steps);
  if (!known) return std::nullopt;
  return with_uncertainty(p, sigma, bracket);
}

report::measurement map_row(const sphere_problem& p, double sigma, double dissipation) {
  const auto found = lyapunov(at(p, sigma, dissipation), map_tolerance);
  return exact_row({.name = "lambda_1 map", .unit = "per time"}, found.lambda1, found.uncertainty, found.reason,
                   {{strength, sigma}, {std::string(dissipation_key), dissipation}});
}

report::measurement border_row(const sphere_problem& p, double sigma, double most) {
  const quantity what{.name = "border of chaos", .unit = std::string(dissipation_key)};
  if (const auto found = border(p, sigma, most))
    return exact_row(what, found->dissipation, found->uncertainty, "", {{strength, sigma}});
  return exact_row(what, {}, 0, fmt::format("lambda_1 is not known to change its sign for theta up to {:g}", most),
                   {{strength, sigma}});
}

}  // namespace

report::measurement exact_row(const quantity& what, std::optional<double> value, double uncertainty,
                              const std::string& reason, std::vector<report::coordinate> at) {
  report::measurement m{.quantity = what.name,
                        .observable = what.observable,
                        .value = value,
                        .unit = what.unit,
                        .method = "exact",
                        .at = std::move(at)};
  if (value) {
    m.low = *value - uncertainty;
    m.high = *value + uncertainty;
  }
  if (!reason.empty()) m.status = reason;
  return m;
}

void report_chaos_border(const context& c, const sphere_problem& p, recorder& record, report::results& out) {
  const auto grid = axes_of(p, c.effort);
  const double most = grid.dissipation.back();
  const auto easiest = lyapunov(at(p, grid.sigma.back(), most / 2), map_tolerance);
  if (!easiest.reason.empty()) {
    out.skipped.push_back({"lyapunov", "", "map and border: even under strong noise lambda_1 is " + easiest.reason});
    return;
  }
  const auto n = static_cast<int>(grid.sigma.size());
  std::vector<report::measurement> map(static_cast<std::size_t>(n * n)), borders(static_cast<std::size_t>(n));
  progress_counter done(n * n + n, c.progress);
  parallel_for(c.threads, n * n + n, [&](int i) {  // a border asks for many exponents, and for most where noise is weak
    const double sigma = grid.sigma[static_cast<std::size_t>(i % n)];
    const auto row = i / n;
    if (row == 0)
      borders[static_cast<std::size_t>(i)] = border_row(p, sigma, most);
    else
      map[static_cast<std::size_t>(i - n)] = map_row(p, sigma, grid.dissipation[static_cast<std::size_t>(row - 1)]);
    done.add();
  });
  for (auto& row : borders) record.row(std::move(row));
  for (auto& row : map) record.row(std::move(row));
}

}  // namespace polhode
