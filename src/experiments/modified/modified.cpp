// SPDX-License-Identifier: Apache-2.0
// Which equation does a scheme really solve at this dt?
//
// T_dt = exp(dt G) with G = log(T_dt)/dt, the generator of the scheme's modified equation (for sigma = 0 that of
// backward error analysis: Hairer, Lubich, Wanner, Geometric Numerical Integration, chapter IX; for weak errors
// Zygalakis, SIAM J. Sci. Comput. 33 (2011) 102, and Abdulle, Cohen, Vilmart, Zygalakis, SIAM J. Sci. Comput. 34 (2012)
// A1800). The rigid body whose generator is nearest to it says what the scheme's inertia, dissipation and noise are in
// effect; what no rigid body does is the residual.
#include "experiments/common/operator_work.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/modified/converging_numbers.hpp"
#include "experiments/modified/modified_constants.hpp"
#include "experiments/modified/modified_report.hpp"
#include "experiments/modified/modified_steps.hpp"
#include "experiments/modified/modified_table.hpp"
#include "experiments/modified/modified_verdict.hpp"

namespace polhode {
namespace {

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
