// The variance in the central limit theorem of time averages, exact: of the equation, and of a scheme at each dt.
//
//   sqrt(T) (1/T int_0^T f(Pi_t) dt - pi(f)) -> N(0, v),   v = -2 pi(g u),  L u = g = f - pi(f)     (Bhattacharya 1982)
//   of a scheme: v = dt (2 pi(g w) - pi(g^2)),  (1 - T) w = g, all with its own law            (Gordin, Lifsic 1978)
#pragma once

#include "experiments/law_averages.hpp"
#include "experiments/transfer_report.hpp"

namespace polhode {

/// Of the observables whose stationary average is known; uncertain by what eight degrees more change.
exact_averages ergodic_variances(const subject&, const law_averages&);

/// The scheme's, from its operator.
Eigen::VectorXd ergodic_variances(const exact_averages&, const transfer_operator&, double dt);

inline constexpr const char* variance_claim = "asymptotic variance converges";

/// Measurements over dt, fits, and the verdict "asymptotic variance converges": the errors (columns `first` …) as power
/// series in dt, whose coefficients below dt^order have to vanish.
void report_ergodic_variances(const exact_averages&, const error_table&, Eigen::Index first, int order,
                              report::results&);

}  // namespace polhode
