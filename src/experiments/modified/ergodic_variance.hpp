// SPDX-License-Identifier: Apache-2.0
// The variance in the central limit theorem of time averages, exact: of the equation, and of a scheme at each dt.
//
//   sqrt(T) (1/T int_0^T f(Pi_t) dt - pi(f)) -> N(0, v),   v = -2 pi(g u),  L u = g = f - pi(f)     (Bhattacharya 1982)
//   of a scheme: v = dt (2 pi(g w) - pi(g^2)),  (1 - T) w = g, all with its own law            (Gordin, Lifsic 1978)
#pragma once

#include "experiments/laws/law_averages.hpp"

namespace polhode {

inline constexpr const char* variance_claim = "asymptotic variance converges";

/// Of the observables whose stationary average is known; uncertain by what eight degrees more change.
exact_averages ergodic_variances(const subject&, const law_averages&);

/// 1 + T + T^2 + … = (1 - T)^-1 on functions without a constant part. Not finite where T keeps one of them.
Eigen::MatrixXd sum_of_powers(const transfer_operator&);

/// The scheme's, from its operator and its sum_of_powers.
Eigen::VectorXd ergodic_variances(const exact_averages&, const transfer_operator&, const Eigen::MatrixXd& forgetting,
                                  double dt);

}  // namespace polhode
