// Errors that carry no sampling error, over several step sizes: measurements, fits and one verdict.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/transfer.hpp"

namespace polhode {

/// The scheme's claimed weak order on this noise.
double weak_order_on(const scheme_info&, noise_class);

/// [level] of one scheme; errors and uncertainties [quantity].
struct error_table {
  std::string scheme;
  std::vector<double> dt;
  std::vector<Eigen::VectorXd> error, uncertainty;
  std::vector<bool> resolved;
};

/// Answers of every wanted scheme at every level, in parallel; the same for any number of threads.
std::vector<error_table> answer_all(const context&, const std::vector<scheme_entry>&, const level_grid&,
                                    const std::function<transfer_question(const scheme_entry&, std::int64_t steps)>&);

/// What is reported of column i.
struct error_column {
  std::string quantity, observable;
  double scale;
};

/// A measurement a level (its interval: the uncertainty) and a fit a column over the levels whose error is fifty times
/// its uncertainty; then the verdict on the order. The slowest column decides: the lowest order among those whose slope
/// has settled (of all, where none has). A slowest order above the claim holds. Where no column has four such levels,
/// the claim holds if all errors are below `negligible_error` of their scale, else it is skipped as not resolved;
/// nothing is concluded where errors are not finite.
void report_orders(const std::string& experiment, const std::string& claim, double expected, const error_table&,
                   const std::vector<error_column>&, report::results& out);

}  // namespace polhode
