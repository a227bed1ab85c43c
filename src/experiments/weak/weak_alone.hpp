// SPDX-License-Identifier: Apache-2.0
// Weak errors of schemes that draw random numbers of their own: no path of another equation is near theirs, and what is
// sampled is held against exact means.
//
// d(dt) = E[f(X_dt)] - E[f(X_T)], the second mean exact (true_means.hpp, exact_means.hpp). Levels of dt have noise of
// their own each. d = a + b dt^p + c dt^(p+1), p the claimed order, by weighted least squares: a is the limit.
#pragma once

#include <functional>
#include <vector>

#include "experiments/common/experiment.hpp"

namespace polhode {

inline constexpr const char* right_means_claim = "means tend to the true ones";

/// For each scheme: |d| a level and observable with its interval, the order of all observables together, and the limit:
/// it holds where every |a| with its 95 % interval stays within 2 % of an observable's size, and is refuted where one
/// is further from zero than all healthy runs but one in a million. Sampling stops by the width of a. Skipped where no
/// mean is known exactly. expected: the claimed order.
void report_orders_alone(const context&, const std::function<double(const scheme_entry&)>& expected, report::results&);

}  // namespace polhode
