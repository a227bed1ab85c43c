// Errors that carry no sampling error, over several step sizes: measurements, fits and one verdict.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/transfer_refine.hpp"

namespace polhode {

/// The scheme's claimed weak order on this noise.
double weak_order_on(const scheme_info&, noise_class);

/// The root of the mean square of f over the sphere: the unit of its errors.
double size_on_sphere(const sphere_function&, double radius);

/// [level] of one scheme; errors and uncertainties [quantity].
struct error_table {
  std::string scheme;
  std::vector<double> dt;
  std::vector<Eigen::VectorXd> error, uncertainty;

  void add(double step, const transfer_answer&);
};

/// What is reported of column i.
struct error_column {
  std::string quantity, observable;
  double scale;
};

/// What every scheme is asked at every level, and the order it claims.
struct order_question {
  std::string experiment, claim;
  std::vector<error_column> columns;
  std::function<double(const scheme_entry&)> expected;
  std::function<transfer_answer(const scheme_entry&, double dt, std::int64_t steps)> answer;
};

/// Answers of every scheme at every level, in parallel; the same for any number of threads. While the slope of a
/// scheme has not settled enough for a verdict its step is halved on, most_halvings times at most.
std::vector<error_table> answer_all(const context&, const std::vector<scheme_entry>&, const level_grid&,
                                    const order_question&);
inline constexpr int most_halvings = 6;

/// A measurement a level (its interval: the uncertainty) and a fit a column over the levels whose error is fifty times
/// its uncertainty.
void report_errors(const order_question&, const error_table&, report::results& out);

/// The same, and the verdict on the order. The slowest column decides: the lowest order among those whose slope
/// has settled (of all, where none has). A slowest order above the claim holds. Where no column has four such levels,
/// the claim holds if all errors are below `negligible_error` of their scale; else nothing is concluded.
void report_orders(const order_question&, double expected, const error_table&, report::results& out);

/// The verdict alone.
report::verdict judge_table(const order_question&, double expected, const error_table&);

/// The verdict on fits of the question's columns, where a column has one.
report::verdict judge_columns(const order_question&, double expected, const std::string& scheme,
                              const std::vector<std::optional<order_fit>>&);

/// Are all errors finite, not negligible, and yet too uncertain for an order?
bool unresolved(const error_table&, const std::vector<error_column>&);

}  // namespace polhode
