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
  odeint::integrate_adaptive(stepper, rhs, mu, 0.0, t, t / 1000);
  return mu;
}

}  // namespace polhode
