// Weak order where no operator can give it: sampled, against the Wong-Zakai equation on the same paths.
//
// d(dt) = E[f(X_dt) - f(X)], X the solution of the ordinary differential equation that the path drives, falls with the
// weak order, and its variance with twice the strong order, so that few paths do. A limit of the paths that is the true
// solution has the true law: it is judged as in experiment strong (path_limit.hpp).
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/laws/transfer_report.hpp"

namespace polhode {

/// For each scheme: |d| a level and observable with its 95 % interval, its variance, the path-steps spent, a fit over
/// the levels whose |d| is five times its standard error (paths resampled), and the verdicts on order and
/// limit; the slowest observable decides on the order, as in report_orders. The time at which paths are compared is the
/// scene's horizon or, if that is shorter, four of the fastest time scales, and the verdicts say which. q: experiment,
/// claim and expected order; functions: one a column of q.
void report_sampled_orders(const context&, const std::vector<scheme_entry>&, const order_question& q,
                           const std::vector<sphere_function>& functions, report::results& out);

}  // namespace polhode
