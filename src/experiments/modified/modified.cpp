// Which equation does a scheme really solve at this dt?
//
// T_dt = exp(dt G) with G = log(T_dt)/dt, the generator of the scheme's modified equation (for sigma = 0 that of
// backward error analysis: Hairer, Lubich, Wanner, Geometric Numerical Integration, chapter IX; for weak errors
// Zygalakis, SIAM J. Sci. Comput. 33 (2011) 102, and Abdulle, Cohen, Vilmart, Zygalakis, SIAM J. Sci. Comput. 34 (2012)
// A1800). The rigid body whose generator is nearest to it says what the scheme's inertia, dissipation and noise are in
// effect; what no rigid body does is the residual.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "experiments/common/undecided.hpp"
#include "experiments/modified/converging_numbers.hpp"
#include "experiments/modified/modified_constants.hpp"
#include "experiments/modified/modified_steps.hpp"
#include "experiments/modified/modified_table.hpp"
#include "experiments/modified/modified_verdict.hpp"

namespace polhode {
namespace {

constexpr const char* gap_claim = "spectral gap converges";
constexpr double nothing_left = 1e-11;  // a residual that is rounding

/// What the scheme claims of the law of one step: its weak order, or without noise the order of its path.
int claimed_order(const subject& s, const scheme_info& info) {
  if (s.model->noise() == noise_class::none) return info.deterministic_order;
  return static_cast<int>(weak_order_on(info, s.model->noise()));
}

/// A parameter's group, columns first ... first + count - 1 of the table, and how it is reported.
struct group {
  const char *quantity, *unit;
  Eigen::Index first, count;
};
constexpr group groups[] = {{"effective inverse inertia", "1/I", 0, 3},
                            {"effective dissipation", "theta/I", 3, 3},
                            {"effective noise", "sigma^2", 6, 6}};

/// Off the diagonal of Q there is something to see where the scene has it, or the scheme makes it.
bool is_shown(const modified_columns& columns, const error_table& t, Eigen::Index column) {
  if (column != 7 && column != 8 && column != 10) return true;
  bool seen = columns.exact[column] != 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    seen = seen || std::fabs(t.error[i][column]) > 10 * t.uncertainty[i][column] + 1e-9 * columns.unit[column];
  return seen;
}

void report_parameter(const group& g, const modified_columns& columns, Eigen::Index column, const error_table& t,
                      report::results& out) {
  const series s{"modified", t.scheme,
                 g.quantity, std::string(modified_columns::names()[static_cast<std::size_t>(column)]),
                 g.unit,     "transfer"};
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double value = columns.exact[column] + t.error[i][column], u = t.uncertainty[i][column];
    out.measurements.push_back(measured(s, t.dt[i], value, value - u, value + u));
  }
}

/// |p - p_scene| of a group against dt, with the order at which it falls.
void report_distance(const group& g, const char* name, const error_table& t, report::results& out) {
  const series s{"modified", t.scheme, "error", name, g.unit, "transfer"};
  std::vector<double> value;
  std::vector<report::measurement> points;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double distance = t.error[i].segment(g.first, g.count).norm(),
                 u = t.uncertainty[i].segment(g.first, g.count).norm();
    value.push_back(distance > 50 * u ? distance : std::numeric_limits<double>::quiet_NaN());
    points.push_back(measured(s, t.dt[i], distance, std::max(0.0, distance - u), distance + u));
  }
  record_fit(out, s, fit_order(t.dt, value, 0), std::move(points));
}

void report_residual(int order, const error_table& t, report::results& out) {
  const series s{"modified", t.scheme, "residual", "", "", "transfer"};
  std::vector<double> value;
  std::vector<report::measurement> points;
  double largest = 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double residual = t.error[i][modified_columns::residual], u = t.uncertainty[i][modified_columns::residual];
    value.push_back(residual > 50 * u ? residual : std::numeric_limits<double>::quiet_NaN());
    largest = std::max(largest, residual - u);
    points.push_back(measured(s, t.dt[i], residual, std::max(0.0, residual - u), residual + u));
  }
  const auto fit = fit_order(t.dt, value, 0);
  record_fit(out, s, fit, std::move(points));
  auto v = judge_order({"modified", t.scheme, "residual falls at the weak order"}, order, fit, true);
  if (!fit && t.dt.size() >= 4 && largest < nothing_left) {
    v.kind = report::verdict_kind::holds;
    v.reason = "no residual: at every dt the scheme solves the equation of a rigid body";
  }
  out.verdicts.push_back(v);
}

/// The scene's own parameters, a level in each plot.
void report_scene(const modified_columns& columns, report::results& out) {
  for (const auto& g : groups)
    for (Eigen::Index j = g.first; j < g.first + g.count; ++j)
      if (columns.exact[j] != 0 || j < 6 || j == 6 || j == 9 || j == 11)
        out.measurements.push_back(
            measured({"modified", "", g.quantity, std::string(modified_columns::names()[static_cast<std::size_t>(j)]),
                      g.unit, "scene"},
                     {}, columns.exact[j]));
}

void report_missing_gap(const std::vector<scheme_entry>& schemes, const known_gap& gap, report::results& out) {
  if (gap.undecided) leave_open(schemes, "modified", gap_claim, "the equation's is " + gap.reason, out);
  if (!gap.undecided && !gap.reason.empty()) out.skipped.push_back({"modified", "", "spectral gap: " + gap.reason});
}

void run(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto columns = columns_on(*s.sphere());
  std::vector<scheme_entry> schemes;
  for (const auto& e : s.schemes) out.verdicts.push_back(judge_steps(c, e));
  for (const auto& e : s.schemes) {
    if (e.info.casimir.exact)
      schemes.push_back(e);
    else
      out.skipped.push_back({"modified", std::string(e.info.name),
                             "leaves the sphere (experiment casimir): its step is no operator on functions there"});
  }
  report_scene(columns, out);
  auto averages = averages_on(s);
  keep_affordable(c, schemes, averages, out);
  const auto variances = ergodic_variances(s, averages);
  const auto gap = true_gap(s);
  report_missing_gap(schemes, gap, out);
  const auto tables = modified_tables(c, schemes, columns, averages, variances, gap);
  const Eigen::Index first_variance = modified_columns::count + averages.count();
  std::vector<int> orders;
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const auto& t = tables[k];
    const int order = claimed_order(s, schemes[k].info);
    orders.push_back(order);
    report_residual(order, t, out);
    const char* names[] = {"inverse inertia", "dissipation", "noise"};
    for (std::size_t i = 0; i < std::size(groups); ++i) report_distance(groups[i], names[i], t, out);
    for (const auto& g : groups)
      for (Eigen::Index j = g.first; j < g.first + g.count; ++j)
        if (is_shown(columns, t, j)) report_parameter(g, columns, j, t, out);
    out.verdicts.push_back(judge_parameters(columns, t, order));
    report_convergence({variance_claim, "error of the asymptotic variance", variances}, t, first_variance, order, out);
    report_convergence({gap_claim, "error of the spectral gap", gap.gap}, t, first_variance + variances.count(), order,
                       out);
  }
  report_leading_constants(c, schemes, averages, tables, orders, out);
}

std::optional<std::string> cannot_say(const subject& s) {
  if (!s.sphere()) return no_exact_law;
  if (!s.sphere()->quadratic.isDiagonal(0) || s.sphere()->has_field())
    return "the family of effective equations has principal axes along the coordinates and no field";
  if (s.model->noise() == noise_class::none && s.sphere()->is_spherical())
    return "a spherical body without noise turns uniformly about a fixed axis: nothing that a function could see";
  return std::nullopt;
}

}  // namespace

experiment modified_experiment() {
  return {
      {"modified",
       "Which equation does the scheme really solve at this dt?",
       {"log(T)/dt, T the scheme's operator of one step (experiment weak), is the generator of its modified equation; "
        "without noise that of backward error analysis. Nothing is sampled. Its columns of degree 1 and 2 by Krylov's "
        "method, so that harmonics cut off by the degree do not matter.",
        "Effective parameters: the rigid body whose generator is nearest in least squares, with 1/I_j, theta/I_j and "
        "the "
        "covariance Q of the noise all free. A common multiple of 1/I, and of theta/I, belongs to the Casimir and is "
        "invisible: both are given less their means. Residual: the share of the generator that no rigid body has "
        "(Frobenius norm).",
        "Parameters converge: differences from the scene as power series in dt; every coefficient below the claimed "
        "weak order (without noise: the deterministic order) has to vanish within its interval, which must be narrower "
        "than 1e-4 of the parameter at the coarsest dt. Intervals: three times the next term of the series, and what "
        "the operators leave uncertain.",
        "Spectral gap: -log|lambda_2|/dt, lambda_2 the second largest eigenvalue of the scheme's operator in modulus "
        "(where two are as large but for the step's error, that of the mode that continues the equation's), against "
        "the least decay rate of the Kolmogorov operator. Asymptotic variance of time averages: both by Poisson "
        "equations. Judged as power series, like the parameters.",
        "dt: from 0.3 of the fastest time scale down, where the logarithm exists."}},
      1,
      cannot_say,
      run};
}

}  // namespace polhode
