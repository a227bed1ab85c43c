// SPDX-License-Identifier: Apache-2.0
// Weak order where no operator can give it: sampled, against the Wong-Zakai equation on the same paths.
//
// d(dt) = E[f(X_dt) - f(X)], X the solution of the ordinary differential equation that the path drives, falls with the
// weak order; its standard deviation falls like dt (twin_chain.hpp), so that few paths do. A limit of the paths that is
// the true solution has the true law: it is judged as in experiment strong (path_limit.hpp).
#pragma once

#include <functional>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "problem/observables.hpp"

namespace polhode {

inline constexpr const char* weak_order_claim = "weak order";
/// The series of sampled errors, and under which observable those of all together stand.
inline constexpr const char *sampled_error = "difference", *all_together = "all, in their sizes";

inline constexpr double clear_error = 5;  ///< standard errors of |d|: from there on a level is fitted

/// For each scheme: |d| a level and observable with its 95 % interval, the variance of all together, the path-steps
/// spent, a fit over the levels whose |d| is five times its standard error (paths resampled), and the verdicts on order
/// and limit. The order is that of all observables together (common_error.hpp); an interval wider than the margin of an
/// order decides nothing. The time at which paths are compared is the scene's horizon or, if that is shorter, four of
/// the fastest time scales, and the verdicts say which. expected: the claimed order.
void report_sampled_orders(const context&, const std::vector<scheme_entry>&, const std::vector<observable>&,
                           const std::function<double(const scheme_entry&)>& expected, report::results& out);

}  // namespace polhode
