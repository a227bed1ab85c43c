// SPDX-License-Identifier: Apache-2.0
// The leading constants of a scheme's errors from its one-step expansion (Talay and Tubaro, Stoch. Anal. Appl. 8 (1990)
// 483): with T_dt = exp(dt L) + dt^(p+1) L_p + …
//
//   E[f(X_T)] - (exp(T L) f)(x)  =  dt^p int_0^T (exp(s L) L_p exp((T - s) L) f)(x) ds  + …
//   pi_dt(f) - pi(f)             = -dt^p pi(L_p u) + …,   L u = f - pi(f).
//
// L_p is the limit of (T_dt - exp(dt L)) / dt^(p+1); nothing of this takes more than one step.
#pragma once

#include "experiments/laws/law_averages.hpp"
#include "statistics/sample.hpp"

namespace polhode {

/// What is the same for all schemes: the equation's own functions and laws in harmonics up to a degree.
class expansion_frame {
 public:
  expansion_frame(const subject&, const law_averages&, int degree, std::vector<double> dt);

  int degree() const { return degree_; }
  const std::vector<double>& dt() const { return dt_; }
  /// One constant an average, with (T_dt - exp(dt L)) / dt^(order + 1) at dt()[level] for L_p.
  Eigen::VectorXd constants(const Eigen::MatrixXd& step, std::size_t level, int order) const;

 private:
  int degree_;
  std::vector<double> dt_;
  std::vector<Eigen::MatrixXd> exact_step_;  ///< exp(dt L)
  Eigen::MatrixXd before_;                   ///< a row a time: the law at s
  std::vector<Eigen::MatrixXd> after_;       ///< at each of them: exp((T - s) L) f, a column an average
  Eigen::VectorXd weight_;                   ///< of the times
  Eigen::RowVectorXd law_;                   ///< stationary
  Eigen::MatrixXd poisson_;                  ///< u, a column an average
};

/// The constants of one scheme, each extrapolated to dt = 0; uncertain by that and by three times what a
/// lower degree changes.
std::vector<interval_estimate> predicted_constants(const subject&, const scheme_entry&, const law_averages&,
                                                   const expansion_frame& coarse, const expansion_frame& fine,
                                                   int order);

}  // namespace polhode
