// SPDX-License-Identifier: Apache-2.0
#include "references/odeint.hpp"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>

namespace polhode {

std::vector<double> solve_drift(const drift_function& drift, std::span<const double> mu0, double t) {
  namespace odeint = boost::numeric::odeint;
  using state = std::vector<double>;
  state mu(mu0.begin(), mu0.end());
  if (t == 0) return mu;
  double scale = 0;
  for (const double x : mu) scale = std::max(scale, std::fabs(x));
  const auto stepper = odeint::make_controlled(1e-14 * scale, 1e-15, odeint::runge_kutta_fehlberg78<state>());
  const auto rhs = [&](const state& x, state& dxdt, double) { drift(x, dxdt); };
  state slope(mu.size());
  drift(mu, slope);
  double rate = 1 / t;
  for (const double x : slope) rate = std::max(rate, std::fabs(x) / scale);
  // Short against the motion however long t is: an overflow in the first trial passes every later test.
  odeint::integrate_adaptive(stepper, rhs, mu, 0.0, t, std::min(t / 1000, 0.01 / rate));
  return mu;
}

}  // namespace polhode
