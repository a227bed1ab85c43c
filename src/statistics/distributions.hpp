// SPDX-License-Identifier: Apache-2.0
// Quantiles and tails of the distributions that intervals are made of: Boost.Math, compiled once.
#pragma once

namespace polhode {

/// x with P(X > x) = tail, X standard normal; 1e-300 where the tail is less.
double normal_deviate(double tail);
/// P(X > x) of the same.
double normal_tail(double x);

/// Half-width of the symmetric 95 % interval of an estimate with a normal error, this standard error, and a bias of at
/// most `bias` >= 0: the 95 % quantile of |N(bias, error^2)| (Armstrong, Kolesar, Econometrica 86 (2018) 655-683).
/// Less than 1.96 error + bias, as the two seldom are at their worst together. NaN of what is not finite.
double half_width_with_bias(double error, double bias);

/// P(X > x), X chi squared of `degrees` > 0 degrees of freedom.
double chi_squared_tail(double x, double degrees);

/// x with P(X <= x) = probability, X with Student's law of `degrees` > 0 degrees of freedom.
double student_t_quantile(double probability, double degrees);

/// P(X > x) of the same.
double student_t_tail(double x, double degrees);

/// P(X <= count) and P(X >= count) of a Poisson count with mean > 0.
double poisson_lower(double count, double mean);
double poisson_upper(double count, double mean);

/// The least count with P(X <= count) >= probability; X binomial, n trials of this share.
double binomial_quantile(double probability, double n, double share);

struct share_bounds {
  double low, high;
};

/// Clopper and Pearson's bounds on a probability after `count` of `n`, each missed with probability `tail`.
share_bounds binomial_bounds(double n, double count, double tail);

}  // namespace polhode
