// Weak order where no operator can give it: sampled, by coupled levels.
//
// d(dt) = E[f(X_dt) - f(X_dt/2)] with both paths driven by one noise falls with the weak order, and its variance with
// twice the strong order, so that few paths do; the limit is not asked for (experiment strong).
#pragma once

#include "experiments/experiment.hpp"
#include "experiments/transfer_report.hpp"

namespace polhode {

/// For each scheme: |d| a level and observable with its 95 % interval, its variance, the path-steps spent, a fit over
/// the levels whose |d| is five times its standard error (paths resampled), and the verdict; the slowest observable
/// decides, as in report_orders. q: experiment, claim and expected order; functions: one a column of q.
void report_sampled_orders(const context&, const std::vector<scheme_entry>&, const order_question& q,
                           const std::vector<sphere_function>& functions, report::results& out);

}  // namespace polhode
