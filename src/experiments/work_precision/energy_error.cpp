// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/energy_error.hpp"

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "references/odeint.hpp"

namespace polhode {

energy_truth::energy_truth(const subject& still, double horizon)
    : still_(still), horizon_(horizon), unit_(energy_size(still)) {}

double energy_truth::error(const scheme_entry& scheme, double dt) const {
  const auto stepper = scheme.make(dt);
  const auto steps = std::lround(horizon_ / dt);
  auto states = replicated(still_.scene.momentum);
  double worst = 0;
  long done = 0;
  for (int k = 1; k <= times; ++k) {
    const long next = steps * k / times;
    if (next == done) continue;
    stepper->advance(states, silence(static_cast<int>(next - done)));
    done = next;
    const double h = still_.model->energy(lane_of(states, 0, still_.model->dimension()));
    if (!std::isfinite(h)) return h;
    worst = std::max(worst, std::fabs(h - at(static_cast<double>(done) * dt)));
  }
  return worst / unit_;
}

double energy_truth::at(double t) const {
  return still_.model->energy(
      solve_drift([&](std::span<const double> mu, std::span<double> out) { still_.model->drift(mu, out); },
                  still_.scene.momentum, t));
}

}  // namespace polhode
