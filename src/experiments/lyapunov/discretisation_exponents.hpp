// SPDX-License-Identifier: Apache-2.0
// The Lyapunov exponents of the discretisations over dt, without sampling (frame_transfer.hpp), against those of the
// equation.
#pragma once

#include "experiments/common/experiment.hpp"
#include "sphere/lyapunov.hpp"

namespace polhode {

inline constexpr const char* exponents_order_claim = "order of the exponents";

/// For each scheme, all of which keep the sphere: the errors of lambda_1 and of lambda_1 + lambda_2 over dt, their fits
/// and a verdict on their order, which is at least the weak one. `exact` has a value.
void report_discretisation_exponents(const context&, const std::vector<scheme_entry>&, const lyapunov_exponents& exact,
                                     report::results&);

}  // namespace polhode
