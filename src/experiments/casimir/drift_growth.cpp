// SPDX-License-Identifier: Apache-2.0
#include "experiments/casimir/drift_growth.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {

double drift_growth::judged() const {
  double judged = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
    judged = std::max(judged, largest[i] * std::min(1.0, judged_steps / steps[i]));
  if (steps.back() >= judged_steps) return judged;
  const auto growth = law();
  return judged * std::pow(judged_steps / steps.back(), growth ? std::clamp(growth->order, 0.5, 1.0) : 1.0);
}

bool drift_growth::has_to_go_on() const {
  if (steps.back() >= judged_steps) return false;
  const double guess = judged();
  return guess > rounding_bound && guess < 10 * rounding_bound;
}

}  // namespace polhode
