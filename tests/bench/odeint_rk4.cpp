// SPDX-License-Identifier: Apache-2.0
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "bench/yardsticks.hpp"

namespace polhode::bench {

momentum odeint_rk4(momentum p, int steps, double dt) {
  constexpr double theta = 0.5;
  static constexpr momentum inverse_inertia{1.0, 1.0 / 2, 1.0 / 3};
  const auto drift = [](const momentum& x, momentum& slope, double) {
    const momentum w{inverse_inertia[0] * x[0], inverse_inertia[1] * x[1], inverse_inertia[2] * x[2]};
    const momentum a{w[0] + theta * (x[1] * w[2] - x[2] * w[1]), w[1] + theta * (x[2] * w[0] - x[0] * w[2]),
                     w[2] + theta * (x[0] * w[1] - x[1] * w[0])};
    slope = {x[1] * a[2] - x[2] * a[1], x[2] * a[0] - x[0] * a[2], x[0] * a[1] - x[1] * a[0]};
  };
  boost::numeric::odeint::runge_kutta4<momentum> stepper;
  for (int i = 0; i < steps; ++i) stepper.do_step(drift, p, i * dt, dt);
  return p;
}

}  // namespace polhode::bench
