// Without noise dh/dt = -theta |ad*_dh mu|^2: how a scheme's own path keeps that law, and how it converges.
#pragma once

#include <span>
#include <string>

#include "experiments/common/experiment.hpp"
#include "experiments/common/levels.hpp"

namespace polhode {

/// One scheme on a scene without noise: the error of the end point against `truth`, by `method`, and the largest
/// |h(t) - h(0) + integral of theta |ad*_dh mu|^2| over dt, each with its order; with dissipation also whether the
/// energy ever rises. Where an order is not clear the steps are halved on: nothing is sampled here, and a leading term
/// can be small by accident. `what` stands before the quantities' names: empty, or "free_" without dissipation.
void report_convergence(const subject&, const scheme_entry&, const level_grid& first, const std::string& what,
                        const std::string& method, std::span<const double> truth, report::results&);

}  // namespace polhode
