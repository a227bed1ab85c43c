// SPDX-License-Identifier: Apache-2.0
// The deterministic system by Boost.Odeint: an independent reference for sigma = 0.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace polhode {

using drift_function = std::function<void(std::span<const double> mu, std::span<double> out)>;

/// State at time t >= 0; Runge-Kutta-Fehlberg 7(8), local error below 1e-14 of the state's size per step.
std::vector<double> solve_drift(const drift_function& drift, std::span<const double> mu0, double t);

}  // namespace polhode
