// SPDX-License-Identifier: Apache-2.0
// Without noise dh/dt = -theta |ad*_dh mu|^2: how a scheme's own path keeps that law, and how it converges.
#pragma once

#include <span>
#include <string>

#include "experiments/common/levels.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {

/// Where the path ends, and how that is known. `prefix` stands before the names of the quantities: empty, or "free_"
/// without dissipation.
struct true_end {
  std::string prefix, method;
  std::span<const double> momentum;
};

/// One scheme on a scene without noise: the error of the end point against the true one, and the largest
/// |h(t) - h(0) + integral of theta |ad*_dh mu|^2| over dt, each with its order; with dissipation also whether the
/// energy ever rises. Where an order is not resolved the steps are halved on: nothing is sampled here, and a leading
/// term can be small by accident.
void report_convergence(const subject&, const scheme_entry&, const level_grid& first, const true_end&, recorder&);

}  // namespace polhode
