// SPDX-License-Identifier: Apache-2.0
// What a run will cost, told before it begins.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "run/shared_work.hpp"
#include "run/verify.hpp"

namespace polhode {

/// Processor time of each scheme in each experiment that applies to the subject, but for what is kept in the store: the
/// steps that the experiment expects at the price of a step as it is measured here in milliseconds, and its operators.
/// Right within a factor of two or so: most experiments end when their intervals are narrow enough.
std::vector<scheme_cost> scheme_costs(const subject&, std::span<const experiment>, const verify_options&);

/// The same of all schemes together, experiment by experiment.
std::vector<expected_cost> forecast(std::span<const experiment>, std::span<const scheme_cost>);

}  // namespace polhode
