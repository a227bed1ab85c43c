// SPDX-License-Identifier: Apache-2.0
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
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/common/judge.hpp"
#include "experiments/common/operator_work.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/laws/law_averages.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "experiments/modified/modified_constants.hpp"
#include "experiments/modified/modified_steps.hpp"
#include "experiments/modified/modified_table.hpp"
#include "experiments/modified/modified_verdict.hpp"
#include "statistics/orders/power_series.hpp"

namespace polhode {
namespace {

// Numbers of the equation that those of a scheme converge to at its weak order, as power series in dt.

struct converging_numbers {
  std::string claim, quantity;  ///< of the verdict; of the measurements, the errors over dt
  exact_averages exact;         ///< names, values other than zero and their uncertainty
};

constexpr double narrow_number = 1e-3;  // half-width, relative, at the coarsest dt

report::verdict judge(const converging_numbers& what, const error_table& t, Eigen::Index first, int order) {
  const auto& averages = what.exact;
  report::verdict v{.expected = 0.0};
  if (t.dt.size() < static_cast<std::size_t>(order) + 2) {
    v.reason = "too few step sizes";
    return v;
  }
  double widest = 0, farthest = 0;  // from zero, in half-widths
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    std::vector<double> value, uncertainty;
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      value.push_back(t.error[level][first + i] / averages.value[i]);
      uncertainty.push_back(t.uncertainty[level][first + i] / averages.value[i]);
    }
    const auto series = series_by_all_levels(t.dt, value, uncertainty, static_cast<std::size_t>(order));
    for (std::size_t power = 0; power < series.size(); ++power) {
      const double unit = std::pow(std::ranges::max(t.dt), static_cast<double>(power));
      const double common = power == 0 ? averages.uncertainty[i] / averages.value[i] : 0;  // to all levels
      const double half = unit * (series[power].high - series[power].low) / 2 + common, at = unit * series[power].value;
      const double far = std::fabs(at) / std::max(half, 1e-300);
      if (far > 1 ? far <= farthest : farthest > 1 || half <= widest) continue;
      (far > 1 ? farthest : widest) = far > 1 ? far : half;
      v.estimate = at;
      v.low = at - half;
      v.high = at + half;
      v.reason = fmt::format("of {} at order dt^{}: {:.2e} [{:.1e}, {:.1e}] of its size",
                             averages.names[static_cast<std::size_t>(i)], power, at, at - half, at + half);
    }
  }
  v.kind = farthest > 1              ? report::verdict_kind::refuted
           : widest <= narrow_number ? report::verdict_kind::holds
                                     : report::verdict_kind::inconclusive;
  return v;
}

/// Over dt, with the order at which it falls.
report::series_id report_errors(const converging_numbers& what, const error_table& t, Eigen::Index first,
                                Eigen::Index i, recorder& record) {
  curve errors{{what.quantity, what.exact.names[static_cast<std::size_t>(i)], "", "transfer"}};
  std::vector<double> resolved;
  for (std::size_t level = 0; level < t.dt.size(); ++level) {
    const double error = std::fabs(t.error[level][first + i]),
                 u = t.uncertainty[level][first + i] + what.exact.uncertainty[i];
    errors.add(t.dt[level], error, std::max(0.0, error - u), error + u);
    resolved.push_back(error > 50 * u ? error : std::numeric_limits<double>::quiet_NaN());
  }
  return record.series(errors, fit_order(t.dt, resolved, 0));
}

/// Measurements over dt, fits, and the verdict: of the relative errors (columns `first` … of the table) all
/// coefficients below dt^order have to vanish (the truth's uncertainty, the same at every dt, is the first one's),
/// within intervals below a thousandth at the coarsest dt.
void report_convergence(const converging_numbers& what, const error_table& t, Eigen::Index first, int order,
                        recorder& record) {
  if (what.exact.count() == 0) return;
  std::vector<report::series_id> errors;
  for (Eigen::Index i = 0; i < what.exact.count(); ++i) errors.push_back(report_errors(what, t, first, i, record));
  record.verdict(what.claim, judge(what, t, first, order), errors);
}

// What is written of a scheme's modified equation: its parameters over dt, their distances from the scene's, the
// residual.

constexpr double nothing_left = 1e-11;  // a residual that is rounding

/// A parameter's group, columns first ... first + count - 1 of the table, and how it is reported.
struct group {
  const char *name, *quantity, *unit;
  Eigen::Index first, count;
};
constexpr group groups[] = {{"inverse inertia", "effective inverse inertia", "1/I", 0, 3},
                            {"dissipation", "effective dissipation", "theta/I", 3, 3},
                            {"noise", "effective noise", "sigma^2", 6, 6}};

std::string name_of(Eigen::Index column) {
  return std::string(modified_columns::names()[static_cast<std::size_t>(column)]);
}

/// Off the diagonal of Q there is something to see where the scene has it, or the scheme makes it.
bool is_shown(const modified_columns& columns, const error_table& t, Eigen::Index column) {
  if (column != 7 && column != 8 && column != 10) return true;
  bool seen = columns.exact[column] != 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    seen = seen || std::fabs(t.error[i][column]) > 10 * t.uncertainty[i][column] + 1e-9 * columns.unit[column];
  return seen;
}

report::series_id report_parameter(const group& g, const modified_columns& columns, Eigen::Index column,
                                   const error_table& t, recorder& record) {
  curve parameter{{g.quantity, name_of(column), g.unit, "transfer"}};
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double value = columns.exact[column] + t.error[i][column], u = t.uncertainty[i][column];
    parameter.add(t.dt[i], value, value - u, value + u);
  }
  return record.series(parameter);
}

/// A norm and its uncertainty over dt, with the order at which it falls.
class norm_over_dt {
 public:
  explicit norm_over_dt(quantity what) : curve_{std::move(what)} {}
  void add(double dt, double norm, double u) {
    curve_.add(dt, norm, std::max(0.0, norm - u), norm + u);
    dt_.push_back(dt);
    resolved_.push_back(norm > 50 * u ? norm : std::numeric_limits<double>::quiet_NaN());
    largest_ = std::max(largest_, norm - u);
  }
  std::optional<order_fit> fit() const { return fit_order(dt_, resolved_, 0); }
  const curve& points() const { return curve_; }
  double largest() const { return largest_; }  ///< surely

 private:
  curve curve_;
  std::vector<double> dt_, resolved_;
  double largest_ = 0;
};

/// |p - p_scene| of a group.
report::series_id report_distance(const group& g, const error_table& t, recorder& record) {
  norm_over_dt distance({"error", g.name, g.unit, "transfer"});
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    distance.add(t.dt[i], t.error[i].segment(g.first, g.count).norm(),
                 t.uncertainty[i].segment(g.first, g.count).norm());
  return record.series(distance.points(), distance.fit());
}

report::series_id report_residual(int order, const error_table& t, recorder& record) {
  norm_over_dt residual({"residual", "", "", "transfer"});
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    residual.add(t.dt[i], t.error[i][modified_columns::residual], t.uncertainty[i][modified_columns::residual]);
  const auto fit = residual.fit();
  const auto written = record.series(residual.points(), fit);
  auto v = judge_order(order, fit, true);
  if (!fit && t.dt.size() >= 4 && residual.largest() < nothing_left) {
    v.kind = report::verdict_kind::holds;
    v.reason = "no residual: at every dt the scheme solves the equation of a rigid body";
  }
  record.verdict("residual falls at the weak order", std::move(v), {written});
  return written;
}

/// Of one scheme, with the verdict on its residual. What the verdict on its parameters rests on.
std::vector<report::series_id> report_modified_equation(const modified_columns& columns, int order,
                                                        const error_table& t, recorder& record) {
  std::vector evidence{report_residual(order, t, record)};
  for (const auto& g : groups) evidence.push_back(report_distance(g, t, record));
  for (const auto& g : groups)
    for (Eigen::Index j = g.first; j < g.first + g.count; ++j)
      if (is_shown(columns, t, j)) evidence.push_back(report_parameter(g, columns, j, t, record));
  return evidence;
}

/// The scene's own parameters, a level in each plot.
void report_own_parameters(const modified_columns& columns, recorder& record) {
  for (const auto& g : groups)
    for (Eigen::Index j = g.first; j < g.first + g.count; ++j)
      if (columns.exact[j] != 0 || j < 6 || j == 6 || j == 9 || j == 11)
        record.value({g.quantity, name_of(j), g.unit, "scene"}, columns.exact[j]);
}

constexpr const char* gap_claim = "spectral gap converges";

/// What the scheme claims of the law of one step: its weak order, or without noise the order of its path.
int claimed_order(const subject& s, const scheme_info& info) {
  if (s.model->noise() == noise_class::none) return info.deterministic_order;
  return static_cast<int>(weak_order_on(info, s.model->noise()));
}

void report_missing_gap(const std::vector<scheme_entry>& schemes, const known_gap& gap, report::results& out) {
  if (gap.undecided) leave_open(schemes, "modified", gap_claim, "the equation's is " + gap.reason, out);
  if (!gap.undecided && !gap.reason.empty()) out.skipped.push_back({"modified", "", "spectral gap: " + gap.reason});
}

void run(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto columns = columns_on(*s.sphere());
  std::vector<scheme_entry> schemes;
  recorder of_scene("modified", "", out);
  for (const auto& e : s.schemes) of_scene.of(e.info.name).verdict(steps_claim, judge_steps(c, e));
  for (const auto& e : s.schemes) {
    if (e.info.casimir.exact)
      schemes.push_back(e);
    else
      out.skipped.push_back({"modified", std::string(e.info.name),
                             "leaves the sphere (experiment casimir): its step is no operator on functions there"});
  }
  report_own_parameters(columns, of_scene);
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
    recorder record("modified", t.scheme, out);
    const auto evidence = report_modified_equation(columns, order, t, record);
    record.verdict(parameters_claim, judge_parameters(columns, t, order), evidence);
    report_convergence({variance_claim, "error of the asymptotic variance", variances}, t, first_variance, order,
                       record);
    report_convergence({gap_claim, "error of the spectral gap", gap.gap}, t, first_variance + variances.count(), order,
                       record);
  }
  report_leading_constants(c, schemes, averages, tables, orders, out);
}

std::optional<std::string> skip_reason(const subject& s) {
  if (!s.sphere()) return no_exact_law;
  if (!s.sphere()->quadratic.isDiagonal(0) || s.sphere()->has_field())
    return "the family of effective equations has principal axes along the coordinates and no field";
  if (!s.sphere()->varying.empty())
    return "the family of effective equations has noise that does not depend on the state";
  if (s.model->noise() == noise_class::none && s.sphere()->is_spherical())
    return "a spherical body without noise turns uniformly about a fixed axis: nothing that a function could see";
  return beyond_reach(s);
}

expected_work work_of(const subject& s, effort) { return {0, by_sphere(s, 0.2, 0.2, 0.2)}; }

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
      work_of,
      skip_reason,
      run};
}

}  // namespace polhode
