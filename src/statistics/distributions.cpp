// SPDX-License-Identifier: Apache-2.0
#include "statistics/distributions.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace polhode {

namespace law = boost::math;

double normal_deviate(double tail) { return law::quantile(law::complement(law::normal(), std::max(tail, 1e-300))); }

double normal_tail(double x) { return law::cdf(law::complement(law::normal(), x)); }

double half_width_with_bias(double error, double bias) {
  constexpr double far = 8;  // from where the other tail is below rounding
  if (error == 0) return bias;
  const double ratio = bias / error;
  if (!std::isfinite(ratio)) return NAN;
  if (ratio > far) return bias + law::quantile(law::normal(), 0.95) * error;
  return error * std::sqrt(law::quantile(law::non_central_chi_squared(1, ratio * ratio), 0.95));
}

double chi_squared_tail(double x, double degrees) { return law::cdf(law::complement(law::chi_squared(degrees), x)); }

double student_t_quantile(double probability, double degrees) {
  return law::quantile(law::students_t(degrees), probability);
}

double student_t_tail(double x, double degrees) { return law::cdf(law::complement(law::students_t(degrees), x)); }

double poisson_lower(double count, double mean) { return law::cdf(law::poisson(mean), count); }

double poisson_upper(double count, double mean) {
  return count == 0 ? 1 : law::cdf(law::complement(law::poisson(mean), count - 1));
}

double binomial_quantile(double probability, double n, double share) {
  using namespace law::policies;
  using rounding_up = policy<discrete_quantile<integer_round_up>>;  // Boost's own rounds the lower half down
  return law::quantile(law::binomial_distribution<double, rounding_up>(n, share), probability);
}

share_bounds binomial_bounds(double n, double count, double tail) {
  using binomial = law::binomial_distribution<double>;
  return {binomial::find_lower_bound_on_p(n, count, tail), binomial::find_upper_bound_on_p(n, count, tail)};
}

}  // namespace polhode
