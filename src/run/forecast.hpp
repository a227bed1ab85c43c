// SPDX-License-Identifier: Apache-2.0
// What a run will cost, told before it begins.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "run/verify.hpp"

namespace polhode {

/// Processor time of the experiments that apply to the subject, in their order: the steps that each expects at the
/// price of a step as it is measured here in milliseconds, and its operators. Nothing for what is kept in the store.
/// Right within a factor of two or so: most experiments end when their intervals are narrow enough.
std::vector<expected_cost> forecast(const subject&, std::span<const experiment>, const verify_options&);

}  // namespace polhode
