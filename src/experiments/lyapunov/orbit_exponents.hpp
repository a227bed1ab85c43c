// The experiment `lyapunov` where the system does not live on one sphere: the whole spectrum on its orbit, sampled.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// Why this scene has no exponents that could be sampled; empty: it has.
std::optional<std::string> no_orbit_exponents(const subject&);

/// Exponents of the equation with what follows from them; of every scheme that keeps the orbit, whether it has the same
/// and whether its sum is the mean divergence.
void report_orbit_exponents(const context&, report::results&);

/// The dimension j + (lambda_1 + ... + lambda_j) / |lambda_{j+1}| of Kaplan and Yorke, j the most whose sum is not
/// negative; 0, a point, where lambda_1 <= 0. Of exponents in decreasing order.
double kaplan_yorke(std::span<const double> exponents);

}  // namespace polhode
